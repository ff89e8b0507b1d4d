// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The vertices of the facets of the convex hull: in 2D edges with the triangulation on their left, in 3D triangles
/// that are counter-clockwise seen from outside. In the order of the cells behind them. Empty unless the points span d
/// dimensions. O(n).
template <int d>
[[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull_facets(const Cell_lists<d>& lists);

/// The neighbours of every vertex, also of points in a plane or on a line. O(n).
template <int d>
[[nodiscard]] Vertex_neighbours vertex_neighbours(const Cell_lists<d>& lists);

/// For each of `points` the number of a cell that contains it, in its interior or on its border; -1 outside the convex
/// hull, for NaN and infinity, and unless the vertices span d dimensions. Exact. A walk begins at the nearest of some
/// cbrt(n) vertices and of the cell found last; expected O(cbrt(n)) for each point, more along a walk through
/// clusters. x: positions by vertex. Precondition: points.size() == out.size(), rounding to nearest.
template <int d>
void find_cells(const Cell_lists<d>& lists, std::span<const Coordinates<d>> x, std::span<const Coordinates<d>> points,
                std::span<Index> out);

}  // namespace annulus::inline v1
