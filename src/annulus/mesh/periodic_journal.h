// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A cell of a Periodic_table as it was.
template <int d>
struct Kept_cell {
    std::size_t cell;
    std::array<Index, static_cast<std::size_t>(d + 1)> vertex;
    std::array<Offset<d>, static_cast<std::size_t>(d + 1)> offset;
    std::array<Corner_index, static_cast<std::size_t>(d + 1)> twin;
    std::array<std::uint8_t, static_cast<std::size_t>(d + 1)> cospherical;  ///< zero in a journal without flags
};

/// The cells of a table before it was changed: each is kept before its first change, so that changes can be undone and
/// what they changed can be examined.
template <int d>
class Periodic_journal {
  public:
    enum class Flags : bool { left, kept };  // Periodic_table::cospherical

    /// Nothing has changed yet. O(number of cells that were kept). Throws bad_alloc.
    void begin(const Periodic_table<d>& table, Flags flags = Flags::left) {
        flags_ = flags;
        for (const Kept_cell<d>& k : kept_) is_kept_[k.cell] = 0;
        kept_.clear();
        size_ = table.size();
        is_kept_.resize(size_, 0);
    }
    /// Before cell c changes. Cells that were not there at the beginning need no call, and it has no effect. Throws
    /// bad_alloc, with nothing changed.
    void keep(const Periodic_table<d>& table, std::size_t c) {
        if (c >= size_ || is_kept_[c] != 0) return;
        kept_.push_back({c, table.vertex[c], table.offset[c], table.twin[c], {}});
        if (flags_ == Flags::kept) kept_.back().cospherical = table.cospherical[c];
        is_kept_[c] = 1;
    }
    /// Before c and what its neighbours are glued to change.
    void keep_around(const Periodic_table<d>& table, std::size_t c) {
        keep(table, c);
        for (const Corner_index t : table.twin[c]) keep(table, table.cell_of(t));
    }
    /// What was kept, each cell once.
    [[nodiscard]] std::span<const Kept_cell<d>> kept() const { return kept_; }
    /// The number of cells at the beginning.
    [[nodiscard]] std::size_t size() const { return size_; }
    /// Makes vertices, offsets and twins of the table, and flags where they were kept, what they were at the beginning.
    void undo(Periodic_table<d>& table) noexcept {
        table.vertex.resize(size_);  // which they had, so nothing is allocated
        table.offset.resize(size_);
        table.twin.resize(size_);
        if (flags_ == Flags::kept) table.cospherical.resize(size_);
        for (const Kept_cell<d>& k : kept_) {
            table.vertex[k.cell] = k.vertex;
            table.offset[k.cell] = k.offset;
            table.twin[k.cell] = k.twin;
            if (flags_ == Flags::kept) table.cospherical[k.cell] = k.cospherical;
        }
    }

  private:
    std::vector<Kept_cell<d>> kept_;
    std::vector<std::uint8_t> is_kept_;  // by cell at the beginning
    std::size_t size_ = 0;
    Flags flags_ = Flags::left;
};

}  // namespace annulus::inline v1
