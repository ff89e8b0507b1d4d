// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/mesh_part.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace annulus::inline v1 {

/// A name and values, one for each point or one for each cell.
struct Vtu_field {
    std::string name;
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint64_t>> values;
};

/// The text of a VTK XML unstructured grid (.vtu) of triangles or tetrahedra, with data in base64, packed by zlib, in
/// the byte order of this machine. In two dimensions z is 0. d is 2 or 3.
///
/// Throws Error(wrong_size) when a field has not one value for every point or cell, Error(unknown_vertex) for an index
/// that names no point. Linear.
template <int d>
[[nodiscard]] std::string write_vtu(std::span<const Coordinates<d>> points,
                                    std::span<const std::array<Index, static_cast<std::size_t>(d) + 1>> cells,
                                    std::span<const Vtu_field> point_fields = {},
                                    std::span<const Vtu_field> cell_fields = {});

/// The same of tetrahedra and then triangles.
[[nodiscard]] std::string write_vtu(const Mesh_part& part, std::span<const Vtu_field> point_fields = {},
                                    std::span<const Vtu_field> cell_fields = {});

extern template std::string write_vtu<2>(std::span<const Coordinates<2>>, std::span<const std::array<Index, 3>>,
                                         std::span<const Vtu_field>, std::span<const Vtu_field>);
extern template std::string write_vtu<3>(std::span<const Coordinates<3>>, std::span<const std::array<Index, 4>>,
                                         std::span<const Vtu_field>, std::span<const Vtu_field>);

}  // namespace annulus::inline v1
