// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/neighbours.h>

namespace annulus::inline v1 {

/// The neighbours of every vertex of a 2D triangulation, at x, whatever its dimension. O(n), or O(n log n) where all
/// vertices are on a line.
void read_neighbours(const Delaunay_mesh<2>& mesh, std::span<const Coordinates<2>> x, Neighbours_2& out);

}  // namespace annulus::inline v1
