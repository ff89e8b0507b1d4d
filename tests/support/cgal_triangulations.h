// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Points for triangulations of CGAL's, and what two of them have in common.
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <support/cases.h>

#include <cstddef>
#include <cstdint>
#include <set>

namespace annulus::testing {

template <int d>
auto point(const Coordinates<d>& x) {
    if constexpr (d == 2) return Kernel::Point_2(x[0], x[1]);
    else return Kernel::Point_3(x[0], x[1], x[2]);
}

template <int d>
Points_of<d> places(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Points_of<d> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0, 1);
    return x;
}

/// The finite cells as sets of points: what two triangulations have in common, whatever their handles.
template <class Dt>
auto cells_of(const Dt& dt) {
    std::set<std::set<typename Dt::Point>> cells;
    const auto take = [&](auto c, int corners) {
        std::set<typename Dt::Point> points;
        for (int i = 0; i < corners; ++i) points.insert(c->vertex(i)->point());
        cells.insert(points);
    };
    if constexpr (requires {
                      dt.finite_faces_begin();
                      dt.number_of_faces();
                  })
        for (auto f = dt.finite_faces_begin(); f != dt.finite_faces_end(); ++f) take(f, 3);
    else
        for (auto c = dt.finite_cells_begin(); c != dt.finite_cells_end(); ++c) take(c, 4);
    return cells;
}

}  // namespace annulus::testing
