// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/formats/taken_columns.h>
#include <annulus/formats/text_input.h>

#include <cstdint>
#include <string>
#include <vector>

namespace annulus {

struct Raw_faces;

/// What one file says before anybody asks for a dimension. Coordinates are finite; z is 0 where there is none.
struct Raw_points {
    std::vector<Coordinates<3>> points;
    std::vector<std::uint64_t> lines;  ///< where each point stands: line, or record in a binary file, from 1
    bool has_z = false;
    Taken_columns columns{};           ///< what was taken for what
    std::vector<std::string> notes{};  ///< what the file says and is not obeyed; each a line with the file's name
    bool ignored_box = false;          ///< a periodic one
};

/// Vertices of an OFF surface, colours, normals and texture coordinates of its variants ignored; its faces when asked.
[[nodiscard]] Raw_points read_off(const Source& source, Raw_faces* faces = nullptr);

/// Vertices of a PLY file, ASCII or binary of either byte order, and when asked the lists vertex_indices (or
/// vertex_index) of its element face; all other elements are stepped over.
[[nodiscard]] Raw_points read_ply(const Source& source, Raw_faces* faces = nullptr);

/// Vertices of a Medit mesh.
[[nodiscard]] Raw_points read_medit_points(const Source& source);

}  // namespace annulus
