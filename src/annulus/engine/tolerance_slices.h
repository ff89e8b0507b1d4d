// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/grow.h>
#include <annulus/internal/index.h>
#include <annulus/mesh/corner_table.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// What is left to do while the tolerances of all certificates are computed in slices, some of them at each time step:
/// where vertices were when this began, which certificates come next, which cells have changed meanwhile.
///
/// All are computed at the positions of the beginning. Until the last slice no tolerance is used: steps test the signs
/// of everything. Then the steps made meanwhile are one step from the positions of the beginning to the present ones:
/// certificates that expired on the way, and those of the cells that changed, are evaluated again (docs/theory.md 5.2).
///
/// Certificates have an order, whatever the number of threads: facets, then cells, by their indices.
template <int d>
class Tolerance_slices {
  public:
    /// Begins at positions x, of which it makes a copy, at which the triangulation is Delaunay. O(n).
    void begin(const Corner_table<d>& table, std::span<const Coordinates<d>> x) {
        changed_.clear();
        grow(changed_, table.cell_bound());
        position_.assign(x.begin(), x.end());
        facets_ = static_cast<std::size_t>(table.facet_bound().value());
        all_ = facets_ + table.cell_bound().offset();
        next_ = 0;
        changes_ = false;
        begun_ = true;
    }
    [[nodiscard]] bool begun() const { return begun_; }
    /// Ends, and releases the memory.
    void end() noexcept {
        begun_ = changes_ = false;
        release(changed_);
        release(position_);
    }

    /// The positions of the beginning.
    [[nodiscard]] std::span<const Coordinates<d>> positions() const { return position_; }
    /// Whether every certificate has been in a slice.
    [[nodiscard]] bool complete() const { return next_ == all_; }
    /// The next slice: places in the order of certificates, from the first of the two to before the second. It has so
    /// many, rounded down, or what is left.
    [[nodiscard]] std::pair<std::size_t, std::size_t> take(double many) {
        const std::size_t first = std::exchange(next_, std::min(all_, next_ + static_cast<std::size_t>(many)));
        return {first, next_};
    }
    /// How many places there are in that order, and how many of these, the first, are of facets.
    [[nodiscard]] std::size_t all() const { return all_; }
    [[nodiscard]] std::size_t facets() const { return facets_; }

    /// These cells are new, or have other neighbours. Those beyond the cells of the beginning need not be named.
    void note_changed(std::span<const Cell_index> cells) {
        changes_ = changes_ || !cells.empty();
        for (const Cell_index c : cells)
            if (changed_.has(c)) changed_[c] = 1;
    }
    /// Whether any was named.
    [[nodiscard]] bool has_changes() const { return changes_; }
    [[nodiscard]] bool has_changed(Cell_index c) const { return !changed_.has(c) || changed_[c] != 0; }
    /// Vertex v is new, and here.
    void place(Index v, const Coordinates<d>& here) {
        const auto i = static_cast<std::size_t>(v);
        if (i >= position_.size()) position_.resize(i + 1);
        position_[i] = here;
    }

  private:
    bool begun_ = false;
    bool changes_ = false;
    std::vector<Coordinates<d>> position_;
    By_cell<std::uint8_t> changed_;  // of the cells of the beginning
    std::size_t facets_ = 0;
    std::size_t all_ = 0;
    std::size_t next_ = 0;
};

}  // namespace annulus::inline v1
