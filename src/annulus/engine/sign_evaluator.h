// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/cost_model.h>
#include <annulus/engine/repair_estimate.h>
#include <annulus/mesh/certificates.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/types.h>

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Tests which certificates hold at given positions, by signs alone: one circumsphere per cell, tested for the cell
/// and its facets, and exact signs where this is not clear.
///
/// What is not clear in the tested cells is on two lists. An entry may occur twice, or be gone; is_inverted and
/// is_violated decide. Positions may change between calls; then the cells that contain the vertex must be tested
/// again.
template <int d>
class Sign_evaluator {
  public:
    explicit Sign_evaluator(const Corner_table<d>& table) : table_(table) {}

    /// For test_all_cells(). Its findings do not depend on the number of threads.
    void set_threads(int threads) { threads_ = threads; }

    /// Starts at positions x. They and the budget, which is charged for every test, must outlive the examination.
    /// O(1).
    void begin(std::span<const Coordinates<d>> x, Budget& budget);

    /// The same positions, elsewhere in memory.
    void rebind(std::span<const Coordinates<d>> x) { x_ = x; }

    /// Tests the cell c and its facets; of an infinite cell the ridges, and with `border` whether it faces the
    /// middle.
    void test_cell(Cell_index c, bool border) {
        budget_->charge(Cost_model<d>::alone);
        test_cell(c, border, found_);
    }
    /// Tests every cell.
    void test_all_cells();
    /// Tests every certificate that contains v.
    void test_star(Index v, bool border);

    /// Exact. A cell with infinity is inverted when its facet faces away from the middle of the points: a hint, not a
    /// certificate.
    [[nodiscard]] bool is_inverted(Cell_index c) { return sign(cell_sites(table_, c)) <= 0; }
    /// Exact; a degenerate certificate is decided by the symbolic perturbation, once its cells are positive.
    [[nodiscard]] bool is_violated(Corner_index f);
    /// Exact sign of a cell with these vertices; infinity allowed.
    [[nodiscard]] int sign(const Cell_sites<d>& x);

    [[nodiscard]] std::vector<Cell_index>& inverted() { return found_.inverted; }  ///< cells
    [[nodiscard]] const std::vector<Cell_index>& inverted() const { return found_.inverted; }
    [[nodiscard]] std::vector<Corner_index>& violated() { return found_.violated; }  ///< facets
    /// What is on the lists: the filter stage counts, in a sample, what clearly fails.
    [[nodiscard]] Repair_estimate estimate();
    /// How many signs each stage decided since begin(), or since the last call of this.
    [[nodiscard]] Stage_counts take_counts() {
        Stage_counts all = std::exchange(decided_, {});
        all.filter += found_.clear_halves / 2;
        found_.clear_halves %= 2;
        return all;
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] const Coordinates<d>* position(Index v) const { return v == infinite ? &*middle_ : &x_[at(v)]; }
    /// What was found in some cells.
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
    std::optional<Coordinates<d>> middle_;  // the mean of some of the points
    Found found_;
    int threads_ = 1;
    Stage_counts decided_;
    Budget* budget_ = nullptr;
};

extern template class Sign_evaluator<2>;
extern template class Sign_evaluator<3>;

}  // namespace annulus::inline v1
