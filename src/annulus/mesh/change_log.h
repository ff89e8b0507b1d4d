// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/limits.h>
#include <annulus/internal/index.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The cells that a Corner_table has lost since begin(), and the places that were written to, however often they were
/// written to and whatever is there now. The table calls record() before it writes. Memory: a mark for each cell of
/// the table, and the cells that went. O(1) for each write.
///
/// On request it also saves the positions before the first write, so that a call that writes no cell, the common one,
/// does not pay for saving them.
template <int d>
class Change_log {
  public:
    using Sites = std::array<Site<d>, static_cast<std::size_t>(d) + 1>;

    /// Starts an empty log.
    void begin() noexcept {
        if (call_ == Limits::stamps) {
            std::fill(marked_.begin(), marked_.end(), 0);
            call_ = 0;
        }
        ++call_;
        written_.clear();
        gone_.clear();
        replaced_ = failed_ = false;
        saved_.clear();
        to_save_ = {};
    }
    /// Positions x, which do not change before the first cell is written, are to be saved then. Throws bad_alloc;
    /// saving itself does not. O(1): the memory that is reserved here is not touched.
    void save_positions(std::span<const Coordinates<d>> x) {
        saved_.reserve(x.size());
        to_save_ = x;
    }
    /// Saves them at once.
    void save_now() noexcept {
        saved_.assign(to_save_.begin(), to_save_.end());
        to_save_ = {};
    }
    /// Empty while no cell has been written.
    [[nodiscard]] std::span<const Coordinates<d>> saved_positions() const noexcept { return saved_; }
    /// Frees their memory.
    void forget_positions() noexcept {
        std::vector<Coordinates<d>>().swap(saved_);
        to_save_ = {};
    }

    /// Cell c of this table is about to be overwritten. Never throws, since tables are also cleared in code that must
    /// not throw: see check().
    template <class Table>
    void record(Cell_index c, const Table& table) noexcept {
        if (replaced_ || failed_ || (marked_.has(c) && marked_[c] == call_)) return;
        if (!to_save_.empty()) save_now();
        try {
            if (!marked_.has(c)) marked_.resize(std::max(c.offset() + 1, 2 * marked_.size()), 0);
            written_.push_back(c);
            if (table.is_cell(c)) note_gone(c, table);
            marked_[c] = call_;
        } catch (const std::bad_alloc&) {
            failed_ = true;
        }
    }
    /// All cells are about to be replaced: from now on the indices of cells mean nothing.
    template <class Table>
    void record_all(const Table& table) noexcept {
        if (replaced_ || failed_) return;
        if (!to_save_.empty()) save_now();
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

    /// Throws bad_alloc if memory ran out while recording.
    void check() const {
        if (failed_) throw std::bad_alloc();
    }
    /// Whether all cells have been replaced.
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
    std::span<const Coordinates<d>> to_save_;
    std::vector<Coordinates<d>> saved_;
};

}  // namespace annulus::inline v1
