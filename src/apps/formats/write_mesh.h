// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/mesh_part.h>

#include <array>
#include <span>
#include <string>

namespace annulus::inline v1 {

/// The text of a Medit mesh (ASCII): triangles in two dimensions, tetrahedra in three, reference 0 throughout. Cells
/// padded with `none` are the simplices of a flat set and have separate sections: Edges, and Triangles in 3D.
///
/// Coordinates are the shortest decimals that read back bit for bit; cells keep their order and orientation, and their
/// indices, from 0 here, are from 1 in the file. d is 2 or 3. Throws Error(not_finite) for a coordinate that no reader
/// would accept and Error(unknown_vertex) for an index that names no point. Linear.
template <int d>
[[nodiscard]] std::string write_mesh(std::span<const Coordinates<d>> points,
                                     std::span<const std::array<Index, static_cast<std::size_t>(d) + 1>> cells);

/// The text of a Medit mesh: the triangles and the tetrahedra. Throws as above.
[[nodiscard]] std::string write_mesh(const Mesh_part& part);

extern template std::string write_mesh<2>(std::span<const Coordinates<2>>, std::span<const std::array<Index, 3>>);
extern template std::string write_mesh<3>(std::span<const Coordinates<3>>, std::span<const std::array<Index, 4>>);

}  // namespace annulus::inline v1
