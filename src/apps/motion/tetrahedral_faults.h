// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/domain_3.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Defects that keep tetrahedra from being a mesh, cell by cell.
struct Cell_fault {
    enum class Kind {
        flat,      ///< no volume
        inverted,  ///< negative, where `other` is positive
        crowded,   ///< the third with a facet that `other` has
        folded     ///< on the same side of a common facet as `other`
    };
    Kind kind;
    std::size_t cell;
    std::size_t other;
};

/// The first cell that has no volume, or is negative while another is positive; else a facet of more than two cells
/// or with two on one side of it; nothing when there is none. Cells that are negative, all of them, are turned.
/// Exact. Precondition: indices name points, which are finite. O(n log n).
[[nodiscard]] std::optional<Cell_fault> cell_fault(std::span<const Coordinates<3>> points,
                                                   std::vector<std::array<Index, 4>>& cells);

/// Triangles that are facets of exactly one cell, counter-clockwise from outside, in the order of the cells, with these
/// cells.
struct Boundary_facets {
    std::vector<std::array<Index, 3>> triangles;
    std::vector<std::size_t> cells;
};
/// Precondition: positive cells without a fault. O(n log n).
[[nodiscard]] Boundary_facets boundary_facets(const std::vector<std::array<Index, 4>>& cells);

/// A cell at a part of the boundary that lies within another part of the mesh without touching its boundary, so that
/// space there is covered twice; nothing when there is none. `domain` is what the facets enclose by the parity of rays.
/// O(n), and one query of it for each connected part of the boundary.
[[nodiscard]] std::optional<std::size_t> covered_twice(const Domain_3& domain, std::span<const Coordinates<3>> points,
                                                       const std::vector<std::array<Index, 4>>& cells,
                                                       const Boundary_facets& facets);

}  // namespace annulus::inline v1
