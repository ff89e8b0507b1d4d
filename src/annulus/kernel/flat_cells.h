// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/mesh/index.h>

#include <span>
#include <vector>

namespace annulus {

/// Appends to `cells` the Delaunay triangulation of vertices that lie in a hyperplane at x: segments between neighbours on
/// a line, triangles in a plane of space; d + 1 entries a cell, padded with `none`. Returns their affine dimension, -1
/// without vertices. Throws Error(collision) naming two at one place. O(n log n).
template <int d>
int flat_cells(std::span<const Coordinates<d>> x, std::vector<Index> vertices, std::vector<Index>& cells);

extern template int flat_cells<2>(std::span<const Coordinates<2>>, std::vector<Index>, std::vector<Index>&);
extern template int flat_cells<3>(std::span<const Coordinates<3>>, std::vector<Index>, std::vector<Index>&);

}  // namespace annulus
