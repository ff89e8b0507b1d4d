// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <functional>
#include <vector>

namespace annulus::inline v1 {

/// What a Moving_delaunay is made of, beside points: pairs of a point and the info of its vertex,
template <class Pair>
struct Pairs {
    std::vector<Pair> all;
};

/// or the finite vertices of a triangulation of CGAL's, in its order.
template <class Other>
struct Originals {
    explicit Originals(const Other& triangulation) {
        vertices.reserve(triangulation.number_of_vertices());
        for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end(); ++v)
            vertices.push_back(v);
    }
    std::vector<typename Other::Vertex_handle> vertices;
};

/// The coordinates of points of CGAL's; point_of(*it) is a point.
template <class View, class It, class Point_of = std::identity>
[[nodiscard]] std::vector<Coordinates<View::d>> coordinates_of(It first, It last, Point_of point_of = {}) {
    std::vector<Coordinates<View::d>> x;
    for (; first != last; ++first) x.push_back(View::coordinates(point_of(*first)));
    return x;
}

}  // namespace annulus::inline v1
