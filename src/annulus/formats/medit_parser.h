// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/formats/text_input.h>

#include <array>
#include <cstdint>
#include <vector>

namespace annulus {

/// Cells with the same number of corners, and the line that each stands on.
template <std::size_t corners>
struct Medit_cells {
    std::vector<std::array<Index, corners>> cells;  ///< from 0
    std::vector<std::uint64_t> lines;
};

/// What a Medit mesh (ASCII) says. Coordinates are finite, indices name points and differ within a cell.
struct Medit_content {
    int dimension = 0;
    std::vector<Coordinates<3>> points;  ///< z is 0 in two dimensions
    std::vector<std::uint64_t> lines;
    bool has_vertices = false;  ///< a section of them, be it empty
    Medit_cells<2> edges;
    Medit_cells<3> triangles;
    Medit_cells<4> tetrahedra;
    std::uint64_t last_line = 1;
};

/// Reads one record a line; sections other than vertices, edges, triangles and tetrahedra are stepped over. A missing
/// End is accepted, since every section says how long it is. Throws Input_error.
[[nodiscard]] Medit_content parse_medit(const Source& source);

}  // namespace annulus
