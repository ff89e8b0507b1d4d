// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <cstddef>

namespace annulus::inline v1 {

/// Adapts a table for for_each_inner_facet. Its finite cells in its order are those of mesh_cells(). A facet is visited
/// from the later cell, so that a pass over the cells needs the circumcentres of the cells before.
template <int d>
struct Cells_of_table {
    const Corner_table<d>& table;

    [[nodiscard]] Index corner(Index c, std::size_t i) const {
        return table.vertex(table.corner(Cell_index(c), static_cast<int>(i)));
    }
    [[nodiscard]] Index beyond(Index c, std::size_t i) const {
        return table.cell_of(table.twin(table.corner(Cell_index(c), static_cast<int>(i)))).value();
    }
    [[nodiscard]] bool is_finite(Index c) const { return !table.is_infinite(Cell_index(c)); }
    [[nodiscard]] static bool owns(Index c, Index n) { return n < c; }
};

}  // namespace annulus::inline v1
