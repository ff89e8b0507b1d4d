// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/limits.h>
#include <annulus/mesh/index.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace annulus {

/// What a Corner_table had, since begin(), in the places that were written to: the cells that went, however often their
/// places were written to and whatever is there now. A table tells it before it writes. Room for a mark a cell of the
/// table and for the cells that went; O(1) a place that is written to.
template <int d>
class Change_log {
  public:
    using Sites = std::array<Site<d>, static_cast<std::size_t>(d) + 1>;

    /// Forgets what it knows.
    void begin() noexcept {
        if (call_ == Limits::stamps) {
            std::fill(marked_.begin(), marked_.end(), 0);
            call_ = 0;
        }
        ++call_;
        written_.clear();
        gone_.clear();
        replaced_ = failed_ = false;
    }

    /// The place of cell c of this table is about to be written to. Never throws, since tables are emptied where
    /// nothing may: see check().
    template <class Table>
    void record(Cell_index c, const Table& table) noexcept {
        if (replaced_ || failed_ || (marked_.has(c) && marked_[c] == call_)) return;
        try {
            if (!marked_.has(c)) marked_.resize(std::max(c.offset() + 1, 2 * marked_.size()), 0);
            written_.push_back(c);
            if (table.is_cell(c)) note_gone(c, table);
            marked_[c] = call_;
        } catch (const std::bad_alloc&) {
            failed_ = true;
        }
    }
    /// All cells are about to go, and others to come: from now on the places mean nothing.
    template <class Table>
    void record_all(const Table& table) noexcept {
        if (replaced_ || failed_) return;
        replaced_ = true;
        try {
            for (const Cell_index c : table.cells()) {
                if (marked_.has(c) && marked_[c] == call_) continue;
                note_gone(c, table);
            }
        } catch (const std::bad_alloc&) {
            failed_ = true;
        }
    }

    /// Throws bad_alloc where there was no memory to write things down.
    void check() const {
        if (failed_) throw std::bad_alloc();
    }
    /// Have all cells gone?
    [[nodiscard]] bool replaced() const noexcept { return replaced_; }
    /// The cells that went, and the places that were written to, each once.
    [[nodiscard]] const std::vector<Sites>& gone() const noexcept { return gone_; }
    [[nodiscard]] const std::vector<Cell_index>& written() const noexcept { return written_; }

  private:
    template <class Table>
    void note_gone(Cell_index c, const Table& table) {
        Sites& sites = gone_.emplace_back();
        for (int i = 0; i <= d; ++i) sites[static_cast<std::size_t>(i)] = table.site(table.corner(c, i));
    }

    By_cell<std::uint32_t> marked_;  ///< the call in which the place was written to last
    std::uint32_t call_ = 0;
    std::vector<Cell_index> written_;
    std::vector<Sites> gone_;
    bool replaced_ = false;
    bool failed_ = false;
};

}  // namespace annulus
