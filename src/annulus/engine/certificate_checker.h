// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/cost_model.h>
#include <annulus/mesh/certificates.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Certificates that are not known to hold at given positions, and the values of those that have been evaluated.
///
/// A caller adds them (`add_*`), each as often as it likes; `evaluate` computes the values of the stale ones in one
/// batch. An entry whose facet or cell a repair has removed stays in the list, but does not exist.
template <int d>
class Certificate_checker {
  public:
    template <class Id, class Points>
    struct Pending {
        Id id;
        std::uint32_t next = 0;  ///< the next entry of the same cell
        Points point{};          ///< its points, in the order of the determinant
        Facet_kind kind{};       ///< of a facet; for a cell `nothing` when it is infinite, else `empty_sphere`
        bool stale = true;       ///< the value is not computed for its present points
        Certificate_value value;
    };
    using Pending_facet = Pending<Corner_index, Facet_sites<d>>;
    using Pending_cell = Pending<Cell_index, Cell_sites<d>>;

    explicit Certificate_checker(const Corner_table<d>& table) : table_(table) {}
    /// For evaluate(). Values and counts do not depend on the number of threads.
    void set_threads(int threads) { threads_ = threads; }

    /// Starts at positions x (one for every vertex index), which must outlive the examination. O(previous entries).
    void begin(std::span<const Coordinates<d>> x);
    /// Removes all entries.
    void clear();
    /// The same, and frees their memory.
    void release_memory() noexcept;
    /// The table is going to change: from now on entries may cease to exist.
    void note_changes() { assign_places(), changing_ = true; }

    void add_facet(Corner_index f);
    void add_cell(Cell_index c);
    /// The same where the facet, or the cell, has no entry yet: nothing is searched.
    void add_new_facet(Corner_index f);
    void add_new_cell(Cell_index c);
    /// Adds every certificate that contains v.
    void add_star(Index v);
    /// Adds every certificate of these cells and of their facets.
    void add_cells(std::span<const Cell_index> cells);

    /// Evaluates the stale entries; evaluate_from() only those from these places on. Returns how many each stage
    /// decided.
    [[nodiscard]] Stage_counts evaluate() { return evaluate_from(0, 0); }
    [[nodiscard]] Stage_counts evaluate_from(std::size_t facet, std::size_t cell);
    /// Evaluates every `stride`th of the stale facets, and of the stale cells.
    [[nodiscard]] Stage_counts evaluate_some(std::size_t stride);
    /// Whether every entry that exists holds. Degenerate spheres are decided by the symbolic perturbation, which
    /// requires positive cells; where a cell is inverted, the answer is false anyway. Precondition: nothing is stale.
    [[nodiscard]] bool all_hold() const;
    /// Whether the certificate does not hold. For a degenerate sphere this is only meaningful once its cells are
    /// positive.
    [[nodiscard]] bool is_violated(const Pending_facet& s) const;
    [[nodiscard]] bool is_violated(const Pending_cell& s) const { return s.value.sign <= 0; }

    [[nodiscard]] std::span<const Pending_facet> facets() const { return facets_; }
    [[nodiscard]] std::span<const Pending_cell> cells() const { return cells_; }
    [[nodiscard]] bool exists(const Pending_facet& s) const { return !changing_ || table_.is_facet(s.id); }
    [[nodiscard]] bool exists(const Pending_cell& s) const { return !changing_ || table_.is_cell(s.id); }

    /// How many entries there are.
    [[nodiscard]] std::size_t size() const { return facets_.size() + cells_.size(); }
    /// The cost, in cells tested, of evaluating all entries by the first stage; below, the cost of an evaluation.
    [[nodiscard]] double pending_cost() const { return Cost_model<d>::evaluation * static_cast<double>(size()); }
    [[nodiscard]] static double cost(const Stage_counts& counts) {
        return Cost_model<d>::evaluation * static_cast<double>(counts.total()) + later_cost(counts);
    }
    /// What of it is for the stages after the filter.
    [[nodiscard]] static double later_cost(const Stage_counts& counts) {
        return interval_evaluation_cost * static_cast<double>(counts.interval) +
               exact_evaluation_cost * static_cast<double>(counts.exact);
    }

  private:
    /// Where an entry is: 1 + twice its place among the facets, or 2 + twice its place among the cells. 0: nowhere.
    using Place = std::uint32_t;
    [[nodiscard]] static Place facet_place(std::size_t i) { return 2 * static_cast<Place>(i) + 1; }
    [[nodiscard]] static Place cell_place(std::size_t i) { return 2 * static_cast<Place>(i) + 2; }
    [[nodiscard]] static bool is_facet_place(Place p) { return (p & 1U) != 0; }
    [[nodiscard]] static std::size_t place(Place p) { return (p - 1) / 2; }
    [[nodiscard]] Place next(Place p) const {
        return is_facet_place(p) ? facets_[place(p)].next : cells_[place(p)].next;
    }
    [[nodiscard]] Place& first_entry_of(Cell_index cell);
    template <class S>
    void enter(S& s, Cell_index cell, Place place);
    [[nodiscard]] Pending_facet& entry(Corner_index f);
    [[nodiscard]] Pending_cell& entry(Cell_index c);
    void describe(Pending_facet& s, Corner_index f) const;
    void describe(Pending_cell& s, Cell_index c) const;
    void assign_places();
    template <class S>
    [[nodiscard]] Stage_counts evaluate_run(std::span<S> entries, std::size_t stride = 1) const;
    template <class S>
    [[nodiscard]] Stage_counts evaluate_stale(std::span<S> entries) const;

    const Corner_table<d>& table_;
    int threads_ = 1;
    std::span<const Coordinates<d>> x_;
    std::vector<Pending_facet> facets_;
    std::vector<Pending_cell> cells_;
    By_cell<Place> entries_of_;  // the first entry of a cell and its facets; the others are linked from it
    bool placed_ = true;         // false: entries_of_ is still to be filled; no certificate is in the list twice
    bool changing_ = false;
};

extern template class Certificate_checker<2>;
extern template class Certificate_checker<3>;

}  // namespace annulus::inline v1
