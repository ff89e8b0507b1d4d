// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/cost_model.h>
#include <annulus/mesh/certificates.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Certificates that are not known to hold at given positions, and the values of those that have been evaluated.
///
/// A caller names them (`add_*`), each as often as it likes; `evaluate` gives those that are stale their values, in
/// one batch. An entry whose facet or cell a repair has taken away stays in the list, and does not exist.
template <int d>
class Certificate_checker {
  public:
    template <class Id, class Points>
    struct Pending {
        Id id;
        std::uint32_t next = 0;  ///< of the same cell
        Points point{};          ///< its points, in the order of the determinant
        Facet_kind kind{};       ///< of a facet; a cell has `nothing` when it is infinite, else `empty_sphere`
        bool stale = true;       ///< value not computed for its present points
        Certificate_value value;
    };
    using Pending_facet = Pending<Corner_index, Facet_sites<d>>;
    using Pending_cell = Pending<Cell_index, Cell_sites<d>>;

    explicit Certificate_checker(const Corner_table<d>& table) : table_(table) {}
    /// For evaluate(). Values and counts do not depend on it.
    void set_threads(int threads) { threads_ = threads; }

    /// Starts at positions x (one for every vertex index), which must outlive the examination. O(entries of before).
    void begin(std::span<const Coordinates<d>> x);
    /// Nothing is pending.
    void clear();
    /// From now on the table changes: entries may cease to exist.
    void note_changes() { assign_places(), changing_ = true; }

    void add_facet(Corner_index f);
    void add_cell(Cell_index c);
    /// Every certificate that contains v.
    void add_star(Index v);
    /// Every certificate of these cells and of their facets.
    void add_cells(std::span<const Cell_index> cells);

    /// Evaluates what is stale, or of it the entries from these places on. Returns how many each stage decided.
    [[nodiscard]] Stage_counts evaluate() { return evaluate_from(0, 0); }
    [[nodiscard]] Stage_counts evaluate_from(std::size_t facet, std::size_t cell);
    /// Whether every entry that exists holds; ties of the sphere are decided by the perturbation, which needs positive
    /// cells: where one is inverted the answer is no anyway. Precondition: nothing is stale.
    [[nodiscard]] bool all_hold() const;
    /// The certificate does not hold. That of a degenerate sphere only counts once its cells are positive.
    [[nodiscard]] bool is_violated(const Pending_facet& s) const;
    [[nodiscard]] bool is_violated(const Pending_cell& s) const { return s.value.sign <= 0; }

    [[nodiscard]] std::span<const Pending_facet> facets() const { return facets_; }
    [[nodiscard]] std::span<const Pending_cell> cells() const { return cells_; }
    [[nodiscard]] bool exists(const Pending_facet& s) const { return !changing_ || table_.is_facet(s.id); }
    [[nodiscard]] bool exists(const Pending_cell& s) const { return !changing_ || table_.is_cell(s.id); }

    /// What it costs, in cells looked at, to evaluate all entries by the first stage; and what evaluation cost.
    [[nodiscard]] double pending_cost() const {
        return Cost_model<d>::evaluation * static_cast<double>(facets_.size() + cells_.size());
    }
    [[nodiscard]] static double cost(const Stage_counts& counts) {
        return Cost_model<d>::evaluation * static_cast<double>(counts.total()) +
               interval_evaluation_cost * static_cast<double>(counts.interval) +
               exact_evaluation_cost * static_cast<double>(counts.exact);
    }

  private:
    /// Where an entry is: 1 + twice its place among facets, or 2 + twice that among cells. 0: nowhere.
    using Place = std::uint32_t;
    [[nodiscard]] static Place facet_place(std::size_t i) { return 2 * static_cast<Place>(i) + 1; }
    [[nodiscard]] static Place cell_place(std::size_t i) { return 2 * static_cast<Place>(i) + 2; }
    [[nodiscard]] static bool is_facet_place(Place p) { return (p & 1U) != 0; }
    [[nodiscard]] static std::size_t place(Place p) { return (p - 1) / 2; }
    [[nodiscard]] Place next(Place p) const {
        return is_facet_place(p) ? facets_[place(p)].next : cells_[place(p)].next;
    }
    template <class S>
    void enter(S& s, Cell_index cell, Place place);
    [[nodiscard]] Pending_facet& entry(Corner_index f);
    [[nodiscard]] Pending_cell& entry(Cell_index c);
    void describe(Pending_facet& s, Corner_index f) const;
    void describe(Pending_cell& s, Cell_index c) const;
    void assign_places();
    template <class S>
    [[nodiscard]] Stage_counts evaluate_run(std::span<S> entries) const;
    template <class S>
    [[nodiscard]] Stage_counts evaluate_stale(std::span<S> entries) const;

    const Corner_table<d>& table_;
    int threads_ = 1;
    std::span<const Coordinates<d>> x_;
    std::vector<Pending_facet> facets_;
    std::vector<Pending_cell> cells_;
    By_cell<Place> entries_of_;  // the first of a cell and its facets, which leads to the others
    bool placed_ = true;         // false: these are still to be filled in; a star has no certificate twice
    bool changing_ = false;
};

extern template class Certificate_checker<2>;
extern template class Certificate_checker<3>;

}  // namespace annulus
