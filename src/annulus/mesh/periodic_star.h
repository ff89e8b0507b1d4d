// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The corners of a periodic table at a vertex, all around one image of it. A cell may have several of them, so corners
/// are walked, not cells.
///
/// A corner of each vertex is kept. Where it is not there any more, because the table was changed or is another one,
/// corners are looked for again, in O(number of cells).
template <int d>
class Periodic_star {
  public:
    /// The table has so many vertices.
    void begin(std::size_t vertices) {
        if (corner_of_.size() != vertices) corner_of_.assign(vertices, no_corner);
    }
    /// After an exception in of(), nothing that was kept can be relied on.
    void forget() noexcept {
        corner_of_.clear();
        found_.clear();
    }
    /// The cell is a new one.
    void add(const Periodic_table<d>& table, std::size_t c) {
        for (std::size_t i = 0; i <= d; ++i)
            corner_of_[static_cast<std::size_t>(table.vertex[c][i])] = table.corner(c, i);
    }
    /// Each corner of v once, in no particular order. Valid until the next call. O(their number). Precondition: v is in
    /// a cell.
    [[nodiscard]] std::span<const Corner_index> of(const Periodic_table<d>& table, Index v) {
        if (found_.size() < 4 * table.size()) found_.resize(4 * table.size(), 0);
        star_.clear();
        if (!is_at(table, corner_of_[static_cast<std::size_t>(v)], v)) find_corners(table);
        find(corner_of_[static_cast<std::size_t>(v)]);
        for (std::size_t k = 0; k < star_.size(); ++k) {
            const std::size_t c = table.cell_of(star_[k]), slot = table.slot_of(star_[k]);
            for (std::size_t i = 0; i <= d; ++i) {
                if (i == slot) continue;
                const std::size_t m = table.cell_of(table.twin[c][i]);
                find(table.corner(m, table.slot(m, table.image(c, slot), table.translation(c, i))));
            }
        }
        for (const Corner_index h : star_) found_[h.offset()] = 0;
        return star_;
    }

  private:
    [[nodiscard]] static bool is_at(const Periodic_table<d>& table, Corner_index h, Index v) {
        return h != no_corner && table.cell_of(h) < table.size() &&
               table.vertex[table.cell_of(h)][table.slot_of(h)] == v;
    }
    void find_corners(const Periodic_table<d>& table) {
        for (std::size_t c = 0; c < table.size(); ++c)
            if (table.vertex[c][0] != none) add(table, c);
    }
    void find(Corner_index h) {
        if (found_[h.offset()] != 0) return;
        found_[h.offset()] = 1;
        star_.push_back(h);
    }

    std::vector<Corner_index> corner_of_;  // by vertex
    std::vector<Corner_index> star_;
    std::vector<std::uint8_t> found_;  // by corner: whether it is in star_, while that grows
};

}  // namespace annulus::inline v1
