// SPDX-License-Identifier: GPL-3.0-or-later
// How `tolerances` starts, when it keeps tolerances, and how it rebuilds.
#include <annulus/engine/tolerance_strategy.h>

#include <annulus/engine/sample.h>
#include <annulus/error.h>

#include <algorithm>
#include <new>
#include <utility>

namespace annulus::inline v1 {

template <int d>
void Tolerance_strategy<d>::resize() {
    const std::size_t n = at(table_.vertex_bound());
    grow(position_, n);
    outcomes_.resize(n);
    if (displacement_budget_.kept() || slices_.begun()) displacement_budget_.resize();
}

/// From now on the cells are updated.
template <int d>
void Tolerance_strategy<d>::stop_rebuilding() {
    if (!std::exchange(rebuilding_, false)) return;
    resize();
}

template <int d>
void Tolerance_strategy<d>::recompute_tolerances(std::span<const Coordinates<d>> x, Move_result& report) {
    const bool own = x.data() == position_.data();
    rebuilding_ = false;
    invalidate_tolerances();
    resize();
    if (own) x = position_;
    compute_tolerances(x, report);
    if (!own) std::copy(x.begin(), x.end(), position_.begin());
}

/// Computes the tolerances of everything at x.
template <int d>
void Tolerance_strategy<d>::compute_tolerances(std::span<const Coordinates<d>> x, Move_result& report) {
    tolerance_policy_.note_recomputed();
    ++report.statistics.tolerance_recomputations;
    displacement_budget_.begin(x);
    if (mesh_.dimension() == d) {
        const auto facets = static_cast<std::size_t>(table_.facet_bound().value());
        evaluate_slice(x, facets, {0, facets + table_.cell_bound().offset()}, report);
    }
    displacement_budget_.finish_beginning();
}

template <int d>
void Tolerance_strategy<d>::begin(std::span<const Coordinates<d>> x, Move_result& report) {
    if (means_ == Means::tolerances) return recompute_tolerances(x, report);
    if (x.data() != position_.data()) position_.assign(x.begin(), x.end());
    drop_tolerances();
    rebuilding_ = means_ == Means::any;
    if (!rebuilding_) resize();
}

template <int d>
void Tolerance_strategy<d>::refresh_all(Move_result& report) {
    if (means_ == Means::signs) return begin(position_, report);
    recompute_tolerances(position_, report);
}

template <int d>
void Tolerance_strategy<d>::begin_transaction(std::span<const Coordinates<d>> x, Move_result& report) {
    saved_ = position_;
    recompute_if_worthwhile(report);
    note_displacements(x);
}

template <int d>
void Tolerance_strategy<d>::commit_transaction(Move_result& report) {
    saved_.clear();
    end_step(true, report);
}

template <int d>
void Tolerance_strategy<d>::rollback() noexcept {
    position_.swap(saved_);
    invalidate_tolerances();
}

template <int d>
void Tolerance_strategy<d>::resume_after_rollback() {
    Move_result discarded;
    refresh_all(discarded);
}

/// Marks tolerances as void, those that are computed in slices, too.
template <int d>
void Tolerance_strategy<d>::invalidate_tolerances() noexcept {
    displacement_budget_.invalidate();
    slices_.end();
}

/// Gives tolerances up: no vertex that moves passes until they are recomputed.
template <int d>
void Tolerance_strategy<d>::drop_tolerances() {
    slices_.end();
    displacement_budget_.drop();
    repair_.checker().release_memory();
    tolerance_policy_.note_dropped();
}

template <int d>
void Tolerance_strategy<d>::add_vertex(Index v, const Coordinates<d>& p) {
    if (at(v) >= position_.size()) position_.resize(at(v) + 1);
    position_[at(v)] = p;
    if (rebuilding_) return;
    resize();
    if (slices_.begun()) slices_.place(v, p);
    if (displacement_budget_.kept() || slices_.begun()) displacement_budget_.add_vertex(v, p);
}

template <int d>
void Tolerance_strategy<d>::restore_position(Index v, const Coordinates<d>& p) noexcept {
    position_[at(v)] = p;
    invalidate_tolerances();
}

template <int d>
void Tolerance_strategy<d>::truncate(std::size_t bound) {
    position_.resize(bound);
    invalidate_tolerances();
}

template <int d>
void Tolerance_strategy<d>::refresh(std::span<const Cell_index> cells, Move_result& report) {
    if (rebuilding_) return;
    resize();
    if (slices_.begun()) slices_.note_changed(cells);
    if (!displacement_budget_.kept()) return;
    Step<d> step = new_step(position_, none, Scope::expired);
    displacement_budget_.begin_anchoring(step);
    Certificate_checker<d>& checker = repair_.checker();
    checker.begin(position_);
    checker.add_cells(cells);
    const Stage_counts counts = checker.evaluate();
    displacement_budget_.commit(step, checker);
    report.statistics.evaluated += counts.total();
    report.statistics.arithmetic += counts;
}

/// Displacements are recorded from time to time while no tolerances are kept, unless they never are.
template <int d>
void Tolerance_strategy<d>::note_displacements(std::span<const Coordinates<d>> x) {
    if (displacement_budget_.kept() || slices_.begun() || means_ == Means::signs)
        tolerance_policy_.forget_displacements();
    else tolerance_policy_.note_displacements(table_, position_, x);
}

template <int d>
void Tolerance_strategy<d>::end_step(bool each, Move_result& report) {
    if (displacement_budget_.kept()) {
        if (tolerance_policy_.end_step_with_tolerances(each, mesh_.vertices())) drop_tolerances();
    } else if (each) {
        tolerance_policy_.note_step_without_tolerances();
    }
    tolerance_policy_.reconsider(table_, repair_.checker(), position_, each, report);
}

/// Called at the end of a time step that was repaired by signs (after a rebuild no tolerances are recomputed), not of
/// the one that decided it: at its beginning it is not known whether a rebuild is to come. `auto` recomputes them in
/// slices, so that no time step costs more than Rebuild_policy::step_limit(); otherwise the two together cost no more
/// than a time step may.
template <int d>
void Tolerance_strategy<d>::recompute_afterwards(Move_result& report) {
    static_assert(Rebuild_policy<d>::share() + Cost_model<d>::recomputation < 1.45 * Cost_model<d>::insertion);
    try {
        if (means_ == Means::any) recompute_slice(report);
        else recompute_if_worthwhile(report);
    } catch (const std::bad_alloc&) {  // the time step has been made
        if (slices_.begun()) drop_tolerances();
    }
}

template <int d>
void Tolerance_strategy<d>::recompute_if_worthwhile(Move_result& report) {
    if (!tolerance_policy_.take_recomputation()) return;
    report.statistics.cost += Cost_model<d>::recomputation * static_cast<double>(mesh_.vertices());
    recompute_tolerances(position_, report);
}

/// While time steps are rebuilt: whether it will pay to repair the next one, judging by this one, which is rebuilt
/// anyway.
template <int d>
bool Tolerance_strategy<d>::next_is_repaired(std::span<const Coordinates<d>> x) {
    constexpr std::size_t most_cells = 512;
    constexpr std::size_t share = 16;
    const std::size_t cells = std::min(most_cells, 1 + x.size() / share);
    return !rebuild_policy_.is_clearly_infeasible(sample_cells<d>(table_, x, cells / 8)) &&
           rebuild_policy_.repairs(sample_cells<d>(table_, x, cells));
}

template <int d>
void Tolerance_strategy<d>::rebuild_all(std::span<const Coordinates<d>> x, bool last, Move_result& report) {
    report.statistics.cost += Rebuild_policy<d>::rebuild_cost(mesh_.vertices());
    mesh_.rebuild(x);
    if (last) stop_rebuilding();
    std::copy(x.begin(), x.end(), position_.begin());
    ++report.statistics.rebuild_steps;
    report.moves.asked += mesh_.vertices();
    report.moves.rebuilt += mesh_.vertices();
}

/// With `any`: repair gave up, or cost more than a rebuild.
template <int d>
void Tolerance_strategy<d>::rebuild_from_now_on() {
    rebuild_policy_.gave_up();
    drop_tolerances();
    rebuilding_ = true;
}

/// After repair gave up. After a duplicate point the cells are rebuilt at the old positions, with other numbers.
template <int d>
void Tolerance_strategy<d>::rebuild(Step<d>& step) {
    try {
        if (means_ == Means::any) rebuild_from_now_on();
        mesh_.rebuild(step.x);
    } catch (const Error&) {
        if (step.mover != none) position_[at(step.mover)] = step.source;
        mesh_.rebuild(position_);
        step.renumbered_all = !rebuilding_;
        throw;
    }
}

template class Tolerance_strategy<2>;
template class Tolerance_strategy<3>;

}  // namespace annulus::inline v1
