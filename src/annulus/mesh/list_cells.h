// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <span>

namespace annulus::inline v1 {

template <int d>
class Corner_table;

/// The finite cells of a table, in its order. O(n).
template <int d>
[[nodiscard]] Mesh_cells<d> mesh_cells(const Corner_table<d>& t);

/// The simplices of points in a plane or on a line, as a list of d + 1 vertices each, padded with `none`. O(n).
template <int d>
[[nodiscard]] Mesh_cells<d> without_neighbours(std::span<const Index> corners);

extern template Mesh_cells<2> mesh_cells<2>(const Corner_table<2>&);
extern template Mesh_cells<3> mesh_cells<3>(const Corner_table<3>&);
extern template Mesh_cells<2> without_neighbours<2>(std::span<const Index>);
extern template Mesh_cells<3> without_neighbours<3>(std::span<const Index>);

}  // namespace annulus::inline v1
