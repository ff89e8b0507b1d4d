// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/replace_periodic_cells.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Replaces any number of cells of a periodic table by others that fill the same space: replace_periodic_cells for
/// cavities. What it has done can be undone, as long as nothing else changes the table, so that new cells can be tested
/// where they are. Buffers are kept from one call to the next.
template <int d>
class Periodic_region {
  public:
    /// `gone` are different cells, `came` the corners of the new ones, in positive order, in the same frame. False,
    /// with nothing changed, where the two do not have the same border, a cell is given twice, or an offset is too
    /// large. Throws bad_alloc, with nothing changed. O(k log k) for k cells.
    [[nodiscard]] bool replace(Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone,
                               std::span<const Cell_images<d>> came);
    /// The numbers of the new cells, in their order, until keep() renumbers cells. The table has a gap for each cell
    /// that went and has no successor: nothing refers to it.
    [[nodiscard]] std::span<const std::size_t> made() const { return numbers_.made; }
    /// Makes the table what it was.
    void undo(Periodic_table<d>& table) noexcept;
    /// Closes the gaps: the last cells take their numbers.
    void keep(Periodic_table<d>& table) noexcept;

  private:
    static constexpr std::size_t corners = d + 1;
    struct Cell {
        std::array<Index, corners> vertex;
        std::array<Offset<d>, corners> offset;
        std::array<Corner_index, corners> twin;
        std::array<std::uint8_t, corners> cospherical;
    };
    /// A facet of the border, as in replace_periodic_cells.
    struct Border_facet {
        Corner_index outer = no_corner;  // the half-facet outside, if it stays
        Facet_images<d> partner{};       // otherwise the facet of the border that this one is glued to
        std::size_t half = 0;            // the new half-facet: (d + 1) * number of the new cell + slot
    };
    /// Of the new cells, and of those that go without a successor.
    struct Numbers {
        std::vector<std::size_t> made, unused;
    };
    /// A new half-facet (below the number of these) or a facet of the border (from there on), by its images.
    struct Side {
        Facet_images<d> images;
        std::size_t number;
    };

    /// The place in `gone`; ~0 where the cell stays.
    [[nodiscard]] std::size_t gone_number(std::size_t cell) const;
    [[nodiscard]] bool find_border(const Periodic_table<d>& table, std::span<const Lifted_cell<d>> gone);
    [[nodiscard]] bool match(std::size_t halves);
    [[nodiscard]] bool find_cells(std::size_t cells, std::span<const Lifted_cell<d>> gone,
                                  std::span<const Cell_images<d>> came);
    [[nodiscard]] Corner_index half(std::size_t h) const {
        return Periodic_table<d>::corner(numbers_.made[h / corners], h % corners);
    }
    static Cell cell_of(const Periodic_table<d>& table, std::size_t c) {
        return {table.vertex[c], table.offset[c], table.twin[c], table.cospherical[c]};
    }
    static void write(Periodic_table<d>& table, std::size_t c, const Cell& cell) noexcept;

    std::vector<std::array<std::size_t, 2>> index_;  // of what goes: cell, place in `gone`; ascending
    std::vector<Border_facet> border_;
    std::vector<Side> sides_;           // ascending
    std::vector<std::size_t> partner_;  // by new half-facet: another one, or their number + that of a border facet
    Numbers numbers_;
    std::vector<Cell> new_, old_;  // old_: those that go, by index_
    std::size_t cells_before_ = 0;
};

extern template class Periodic_region<2>;
extern template class Periodic_region<3>;

}  // namespace annulus::inline v1
