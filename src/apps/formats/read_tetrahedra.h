// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/tetrahedral_faults.h>
#include <apps/motion/triangle_surface.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A tetrahedral mesh from a file: positive cells that meet only in common facets, edges and corners, and their
/// boundary.
///
/// Points are finite, differ and are all used, in the order of the file. Not checked: that no part of the mesh lies
/// within another without touching its boundary.
struct Tetrahedra_file {
    std::string name;
    std::vector<Coordinates<3>> points;
    std::vector<std::array<Index, 4>> cells;
    std::vector<std::uint64_t> cell_lines;
    Boundary_facets boundary;
    std::uint64_t merged = 0;  ///< points that were equal to another one
    std::uint64_t unused = 0;  ///< points without a cell
    bool turned = false;       ///< whether all cells were negative

    /// The boundary as a surface with only its own points, in their order.
    [[nodiscard]] Triangle_surface surface() const;
};

/// Reads a 3D Medit mesh (ASCII, .mesh). Equal points are merged, points without a cell dropped, cells reversed where
/// all are negative; triangles, edges and references of the file are not needed: the boundary consists of the facets of
/// only one cell. Throws Input_error for every fault of the file, including cells without volume, cells inverted
/// relative to others, a facet of more than two cells, hanging nodes, an edge in more than two facets of the boundary
/// and a boundary that crosses or touches itself. O(n log n), and the pairs of boundary facets whose boxes meet.
[[nodiscard]] Tetrahedra_file read_tetrahedra(const std::filesystem::path& file);

}  // namespace annulus::inline v1
