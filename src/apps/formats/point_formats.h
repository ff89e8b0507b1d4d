// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/taken_columns.h>
#include <apps/formats/text_input.h>
#include <apps/motion/file_box.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

struct Raw_faces;

/// The content of one file, before the dimension is chosen. Coordinates are finite; z is 0 where there is none.
struct Raw_points {
    std::vector<Coordinates<3>> points;
    std::vector<std::uint64_t> lines;  ///< of each point: line, or record in a binary file, from 1
    bool has_z = false;
    Taken_columns columns{};           ///< which columns were taken
    std::vector<std::string> notes{};  ///< content of the file that is ignored; each a line with the file's name
    bool ignored_box = false;          ///< whether a periodic box was ignored
    std::optional<File_box> box{};     ///< where boxes are taken
};

/// Vertices of an OFF surface, and its faces on request; colours, normals and texture coordinates are ignored.
[[nodiscard]] Raw_points read_off(const Source& source, Raw_faces* faces = nullptr);

/// Vertices of a PLY file, ASCII or binary of either byte order, and on request the lists vertex_indices (or
/// vertex_index) of its element face; all other elements are skipped.
[[nodiscard]] Raw_points read_ply(const Source& source, Raw_faces* faces = nullptr);

/// Vertices of a Medit mesh.
[[nodiscard]] Raw_points read_medit_points(const Source& source);

}  // namespace annulus::inline v1
