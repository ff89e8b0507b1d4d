// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/mesh_part.h>
#include <apps/formats/write_vtu.h>

#include <span>
#include <string>

namespace annulus::inline v1 {

// Meshes in text, for other programs. Coordinates and values are the shortest decimals that read back bit for bit;
// tetrahedra come first, then triangles, both in their order and orientation. They throw Error(not_finite) for a
// coordinate that is not finite, Error(unknown_vertex) for an index that names no point, and Error(wrong_size) for a
// field without one value for every point or cell. Linear.

enum class Msh_version { v2_2, v4_1 };

/// The text of a Gmsh mesh (.msh, ASCII). The tetrahedra are the physical group "domain" (3, tag 1), the triangles
/// "surface" (2, tag 2); points and cells are numbered from 1. Fields are views: $NodeData, $ElementData.
[[nodiscard]] std::string write_msh(const Mesh_part& part, Msh_version version,
                                    std::span<const Vtu_field> point_fields = {},
                                    std::span<const Vtu_field> cell_fields = {});

/// The text of a legacy VTK file, version 4.2 (.vtk, ASCII), which all releases of VTK and meshio read. Names of fields
/// are without blanks.
[[nodiscard]] std::string write_vtk(const Mesh_part& part, std::span<const Vtu_field> point_fields = {},
                                    std::span<const Vtu_field> cell_fields = {});

}  // namespace annulus::inline v1
