// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh_cells.h>

#include <span>

namespace annulus::inline v1 {

template <int d>
class Corner_table;

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
