// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/text_input.h>

#include <array>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// Cells with the same number of corners, and the line of each.
template <std::size_t corners>
struct Medit_cells {
    std::vector<std::array<Index, corners>> cells;  ///< from 0
    std::vector<std::uint64_t> lines;
};

/// The content of a Medit mesh (ASCII). Coordinates are finite, indices name points and differ within a cell.
struct Medit_content {
    int dimension = 0;
    std::vector<Coordinates<3>> points;  ///< z is 0 in two dimensions
    std::vector<std::uint64_t> lines;
    bool has_vertices = false;  ///< whether there is such a section, even an empty one
    Medit_cells<2> edges;
    Medit_cells<3> triangles;
    Medit_cells<4> tetrahedra;
    std::uint64_t last_line = 1;
};

/// Reads one record per line; sections other than vertices, edges, triangles and tetrahedra are skipped. A missing End
/// is accepted, since every section states its length. Throws Input_error.
[[nodiscard]] Medit_content parse_medit(const Source& source);

}  // namespace annulus::inline v1
