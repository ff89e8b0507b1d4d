// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/cost_model.h>
#include <annulus/mesh/clear_periodic_cells.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Tests which certificates of a periodic table hold at given places: Sign_evaluator for cells with offsets. Exact;
/// cospherical points are decided by the perturbation.
///
/// What does not hold in the tested cells is on two lists. An entry may occur twice, or be gone, or hold by now;
/// is_inverted and is_violated decide. Places may change between calls; then the cells that contain the vertex must be
/// tested again.
template <int d>
class Periodic_signs {
  public:
    using Cospherical = std::vector<std::array<std::uint8_t, static_cast<std::size_t>(d + 1)>>;

    /// All of these must outlive the examination. Empties the lists.
    void begin(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> x,
               Budget& budget);

    /// The most threads of test_all_cells(), 1 at first. Nothing else depends on it.
    void set_threads(int threads) { clear_.set_threads(threads); }
    /// Tests every cell, and finds which facets are cospherical. Stops, and returns false, where it costs more than the
    /// budget to repair what has been found so far.
    [[nodiscard]] bool test_all_cells();
    /// What it costs to repair what is on the lists, roughly, in the unit of the budget.
    [[nodiscard]] double expected_cost() const;
    /// Tests the cell c and its facets.
    void test_cell(std::size_t c);
    /// Exact. A flat cell is inverted, too.
    [[nodiscard]] bool is_inverted(std::size_t c) { return sign(table_->images(c)) <= 0; }
    /// Exact. False where one of its cells is inverted, unless it is clear that the sphere of the cell of h, which is
    /// not, contains the opposite vertex.
    [[nodiscard]] bool is_violated(Corner_index h);
    /// Exact sign of a cell with these corners.
    [[nodiscard]] int sign(const Cell_images<d>& cell);

    [[nodiscard]] std::vector<std::size_t>& inverted() { return inverted_; }   ///< cells
    [[nodiscard]] std::vector<Corner_index>& violated() { return violated_; }  ///< facets, by one of their halves

    /// What test_all_cells() found, as Periodic_table::cospherical.
    [[nodiscard]] Cospherical& cospherical() { return cospherical_; }

  private:
    using Places = std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)>;

    [[nodiscard]] Coordinates<d> at(Image<d> s) const {
        const Coordinates<d>& x = x_[static_cast<std::size_t>(s.vertex)];
        return s.label.is_zero() ? x : lattice_->place(x, s.label);
    }
    [[nodiscard]] Places places(std::size_t c, Offset<d> shift = {}) const {
        Places x;
        for (std::size_t i = 0; i <= d; ++i) x[i] = at(table_->image(c, i, shift));
        return x;
    }
    /// The place of the vertex opposite to facet i of c, as c sees it.
    [[nodiscard]] Coordinates<d> opposite(std::size_t c, std::size_t i) const {
        const Corner_index t = table_->twin[c][i];
        return at(
            table_->image(Periodic_table<d>::cell_of(t), Periodic_table<d>::slot_of(t), table_->translation(c, i)));
    }
    [[nodiscard]] int sign(const Places& x);
    /// 1 where the facet holds, 0 where it holds by the perturbation alone, -1 where it is violated, 2 where one of its
    /// cells is inverted.
    [[nodiscard]] int sign_of_facet(std::size_t c, std::size_t i);
    void test_cell(std::size_t c, Cospherical* cospherical);

    const Periodic_table<d>* table_ = nullptr;
    const Lattice<d>* lattice_ = nullptr;
    std::span<const Coordinates<d>> x_;
    Budget* budget_ = nullptr;
    std::vector<std::size_t> inverted_;
    std::vector<Corner_index> violated_;
    Cospherical cospherical_;
    Clear_periodic_cells<d> clear_;
};

extern template class Periodic_signs<2>;
extern template class Periodic_signs<3>;

}  // namespace annulus::inline v1
