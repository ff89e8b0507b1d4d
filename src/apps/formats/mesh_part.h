// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Tetrahedra and the triangles around them, with their own points only: what a mesh generator would hand over.
/// Fields of cells have a value for each tetrahedron, then for each triangle.
struct Mesh_part {
    std::vector<Coordinates<3>> points;
    std::vector<std::array<Index, 4>> tetrahedra;
    std::vector<std::array<Index, 3>> triangles;
};

/// Some tetrahedra of a triangulation with the triangles around them. Points keep their order. Throws
/// Error(unknown_vertex) for an index that names no point, or a corner of a triangle that no tetrahedron has. Linear.
[[nodiscard]] Mesh_part mesh_part(std::span<const Coordinates<3>> points, std::span<const std::array<Index, 4>> cells,
                                  std::span<const std::array<Index, 3>> boundary);

}  // namespace annulus::inline v1
