// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/input_error.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace annulus::inline v1 {

/// A mesh from a file: triangles in two dimensions, tetrahedra in three, in the order and orientation of the file.
/// Coordinates are finite; indices are from 0, name points, and differ within a cell. A file without such cells gives
/// its triangles or else its edges, padded with `none`: the triangulation of points in a plane or on a line.
template <int d>
struct Mesh_file {
    std::string name;
    std::vector<Coordinates<d>> points;
    std::vector<std::array<Index, static_cast<std::size_t>(d) + 1>> cells;
    std::vector<std::uint64_t> point_lines;  ///< from 1
    std::vector<std::uint64_t> cell_lines;
};

/// Reads a Medit mesh (ASCII, .mesh) that declares dimension d. Throws Input_error, also for a mesh without points or
/// cells. Linear in the size of the file, which is held in memory.
[[nodiscard]] std::variant<Mesh_file<2>, Mesh_file<3>> read_mesh(const std::filesystem::path& file);

}  // namespace annulus::inline v1
