// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>

#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The places of a Corner_table that were written to since clear(), which a copy of the table has to update. When they
/// exceed a share of all places, or memory runs out, it reports "everything" and recording is free from then on.
class Dirty_cells {
  public:
    void clear() noexcept {
        for (const Cell_index c : cells_) marked_[c] = 0;
        cells_.clear();
        everything_ = false;
    }
    /// Cell c, of a table with `places` places, is about to be overwritten. Amortised O(1).
    void record(Cell_index c, std::size_t places) noexcept {
        if (everything_ || (marked_.has(c) && marked_[c] != 0)) return;
        constexpr std::size_t few = 64, share = 4;
        if (cells_.size() > few + places / share) return record_all();
        try {
            if (!marked_.has(c)) marked_.resize(std::max(c.offset() + 1, 2 * marked_.size()), 0);
            cells_.push_back(c);
            marked_[c] = 1;
        } catch (const std::bad_alloc&) {
            record_all();
        }
    }
    void record_all() noexcept {
        clear();
        everything_ = true;
    }
    [[nodiscard]] bool everything() const noexcept { return everything_; }
    /// Each cell once, unless everything().
    [[nodiscard]] std::span<const Cell_index> cells() const noexcept { return cells_; }

  private:
    By_cell<char> marked_;  // whether it is in cells_
    std::vector<Cell_index> cells_;
    bool everything_ = true;
};

}  // namespace annulus::inline v1
