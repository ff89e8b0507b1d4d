// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The finite neighbours of every vertex of a 2D triangulation in counter-clockwise order, all lists in one array.
///
/// Vertex v has the neighbours `of(v)`. When `hull[v]` is 0 the list is cyclic: consecutive entries u, w (and last,
/// first) span the finite triangle (v, u, w). When `hull[v]` is 1 the vertex is on the convex hull (or the whole
/// triangulation is collinear) and the list is open: it starts with the neighbour that follows infinity, and last,
/// first span no triangle. Free indices (removed vertices) have an empty list.
struct Neighbours_2 {
    std::vector<Index> begin;   ///< size() + 1 offsets into `vertex`
    std::vector<Index> vertex;  ///< neighbour indices
    std::vector<char> hull;     ///< 1 where the list is open

    [[nodiscard]] std::size_t size() const { return hull.size(); }
    [[nodiscard]] std::span<const Index> of(std::size_t v) const {
        return {vertex.data() + begin[v], static_cast<std::size_t>(begin[v + 1] - begin[v])};
    }
};

}  // namespace annulus::inline v1
