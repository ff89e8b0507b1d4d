// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <array>
#include <span>
#include <vector>

namespace annulus::inline v1 {

template <int d>
class Corner_table;

/// The finite cells of a triangulation, numbered 0, 1, 2 .., and their adjacency.
template <int d>
struct Mesh_cells {
    static constexpr Index outside = -1;  ///< instead of a neighbour: beyond the hull
    /// d + 1 vertex indices for each cell, positively oriented: counter-clockwise in 2D; in 3D the first three turn
    /// left as seen from the fourth, so that det(b - a, c - a, e - a) > 0. Padded with `none` where all points are in
    /// a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> vertices;
    /// The cell beyond the facet opposite to each vertex; `outside` beyond the hull, and everywhere where all points
    /// are in a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> neighbours;
};

/// The finite cells of a table, in its order. O(n).
template <int d>
[[nodiscard]] Mesh_cells<d> mesh_cells(const Corner_table<d>& t);

/// The cells of a list of d + 1 vertices each, which are below `bound`, or padded with `none`. Neighbours are found by
/// the facets. O(n).
template <int d>
[[nodiscard]] Mesh_cells<d> mesh_cells(std::span<const Index> corners, std::size_t bound);

extern template Mesh_cells<2> mesh_cells<2>(const Corner_table<2>&);
extern template Mesh_cells<3> mesh_cells<3>(const Corner_table<3>&);
extern template Mesh_cells<2> mesh_cells<2>(std::span<const Index>, std::size_t);
extern template Mesh_cells<3> mesh_cells<3>(std::span<const Index>, std::size_t);

}  // namespace annulus::inline v1
