// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A translate of a cell of a Periodic_table: what is added to its offsets.
template <int d>
struct Lifted_cell {
    std::size_t cell;
    Offset<d> shift;
    friend bool operator==(const Lifted_cell&, const Lifted_cell&) = default;
};

/// The cell beyond facet i of a lifted cell, in the same frame.
template <int d>
[[nodiscard]] Lifted_cell<d> beyond(const Periodic_table<d>& table, Lifted_cell<d> c, std::size_t i) {
    return {Periodic_table<d>::cell_of(table.twin[c.cell][i]), c.shift + table.translation(c.cell, i)};
}

/// The most cells that are replaced at once: flips need no more.
inline constexpr std::size_t most_replaced = 4;

/*
    +-----+-----+        A facet of the border of what is replaced may be glued to a translate of another facet of it
    |  U  | U+t |        (1 and 2 here). So the border is kept by images: what is outside of a facet, or which facet of
    1     2     |        the border it is glued to; and glued when the new cells are there.
    +-----+-----+
*/
/// Replaces cells by others that fill the same space, with all of their translates. `gone` are different cells, `came`
/// the corners of the new ones, in positive order, in the same frame. A cell that goes has the vertex `none` first, and
/// its number is on `unused`; new ones take numbers of those that go, then unused ones, then new ones: `made` receives
/// them. False, with nothing changed, where the two do not have the same border, a cell is given twice, or an offset
/// is too large. Throws bad_alloc, with a table that is of no use. O(1).
template <int d>
[[nodiscard]] bool replace_periodic_cells(Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone,
                                          std::span<const Cell_images<d>> came, std::vector<std::size_t>& unused,
                                          std::vector<std::size_t>& made);

/// Gives the cells numbers without gaps. O(number of gaps).
template <int d>
void close_gaps(Periodic_table<d>& table, std::vector<std::size_t>& unused);

extern template bool replace_periodic_cells(Periodic_table<2>&, std::span<const Lifted_cell<2>>,
                                            std::span<const Cell_images<2>>, std::vector<std::size_t>&,
                                            std::vector<std::size_t>&);
extern template bool replace_periodic_cells(Periodic_table<3>&, std::span<const Lifted_cell<3>>,
                                            std::span<const Cell_images<3>>, std::vector<std::size_t>&,
                                            std::vector<std::size_t>&);
extern template void close_gaps(Periodic_table<2>&, std::vector<std::size_t>&);
extern template void close_gaps(Periodic_table<3>&, std::vector<std::size_t>&);

}  // namespace annulus::inline v1
