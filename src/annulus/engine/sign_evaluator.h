// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/cost_model.h>
#include <annulus/engine/move_report.h>
#include <annulus/mesh/certificates.h>
#include <annulus/predicate/exact_sign.h>

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus {

/// Which certificates hold at given positions, by signs alone: one circumsphere a cell, asked for the cell and its
/// facets, and exact signs where that is not clear.
///
/// What is not clear of the cells looked at is on two lists, in which an entry may occur twice, or be gone;
/// is_inverted and is_violated tell. Positions may change between calls; then what contains the vertex has to be
/// looked at again.
template <int d>
class Sign_evaluator {
  public:
    explicit Sign_evaluator(const Corner_table<d>& table) : table_(table) {}

    /// For test_all_cells(). What it finds does not depend on it.
    void set_threads(int threads) { threads_ = threads; }

    /// Starts at positions x. These and the budget, which is charged with what is asked, must outlive the
    /// examination. O(1).
    void begin(std::span<const Coordinates<d>> x, Budget& budget);

    /// The same positions, elsewhere in memory.
    void rebind(std::span<const Coordinates<d>> x) { x_ = x; }

    /// The cell c and its facets; of an infinite cell the ridges, and with `border` whether it faces the middle.
    void test_cell(Cell_index c, bool border) {
        budget_->charge(Cost_model<d>::alone);
        test_cell(c, border, found_);
    }
    /// Every cell.
    void test_all_cells();
    /// Every certificate that contains v.
    void test_star(Index v, bool border);

    /// Exact. A cell with infinity is inverted when its facet faces away from the middle of the points: that is a
    /// hint, no certificate.
    [[nodiscard]] bool is_inverted(Cell_index c) { return sign(cell_sites(table_, c)) <= 0; }
    /// Exact; what is degenerate is decided by the perturbation, once its cells are positive.
    [[nodiscard]] bool is_violated(Corner_index f);
    /// Exact sign of a cell with these vertices; infinity allowed.
    [[nodiscard]] int sign(const Cell_sites<d>& x);

    [[nodiscard]] std::vector<Cell_index>& inverted() { return found_.inverted; }    ///< cells
    [[nodiscard]] std::vector<Corner_index>& violated() { return found_.violated; }  ///< facets
    /// About what it will cost at least to repair what is on the lists: by a sample, of which the filter stage is asked
    /// what clearly fails.
    [[nodiscard]] double estimate();
    /// What was asked since begin(), or since this was called last, by stage.
    [[nodiscard]] Stage_counts take_counts() {
        Stage_counts all = std::exchange(decided_, {});
        all.filter += found_.clear_halves / 2;
        found_.clear_halves %= 2;
        return all;
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] const Coordinates<d>* position(Index v) const { return v == infinite ? &*middle_ : &x_[at(v)]; }
    /// What was seen of some cells.
    struct Found {
        std::vector<Cell_index> inverted;
        std::vector<Corner_index> violated;
        std::uint64_t clear_halves = 0;
        std::uint64_t cells = 0;
    };
    void test_cell(Cell_index c, bool border, Found& found) const;
    void take(const Found& found);
    int decided(Staged_sign s);
    [[nodiscard]] bool clearly(int sign);
    [[nodiscard]] int sphere_sign(Corner_index h);
    void find_middle();

    const Corner_table<d>& table_;
    std::span<const Coordinates<d>> x_;
    std::optional<Coordinates<d>> middle_;  // of some of the points
    Found found_;
    int threads_ = 1;
    Stage_counts decided_;
    Budget* budget_ = nullptr;
};

extern template class Sign_evaluator<2>;
extern template class Sign_evaluator<3>;

}  // namespace annulus
