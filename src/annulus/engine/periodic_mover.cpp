// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_mover.h>

#include <annulus/engine/cost_model.h>
#include <annulus/space/nearest_shift.h>

#include <algorithm>
#include <cmath>
#include <new>

namespace annulus::inline v1 {

namespace {

/// A length that is typical of edges.
template <int d>
double spacing_of(const Periodic_state<d>& state) {
    const double each = state.lattice.volume() / static_cast<double>(state.vertices());
    return d == 2 ? std::sqrt(each) : std::cbrt(each);
}

/// How far a vertex goes, to the image that is nearest to it.
template <int d>
double squared_way(const Periodic_state<d>& state, const Vertex_move<d>& m) {
    const Coordinates<d> from = state.representative(m.vertex).place;
    Coordinates<d> way;
    for (std::size_t i = 0; i < d; ++i) way[i] = m.to.place[i] - from[i];
    const Coordinates<d> nearest = nearest_vector<d>(state.lattice, way);
    double squared = 0;
    for (std::size_t i = 0; i < d; ++i) squared += (way[i] - nearest[i]) * (way[i] - nearest[i]);
    return squared;
}

}  // namespace

/// Flips take a vertex no farther than a spacing; in a move that is longer all is built. That tolerances are lost is
/// not counted: where calls of some vertices follow one another none are kept.
template <int d>
bool Periodic_mover<d>::is_for_editor(const Periodic_state<d>& state, std::span<const Vertex_move<d>> moves) const {
    using Costs = Periodic_costs<d>;
    const double n = static_cast<double>(state.vertices()), spacing = spacing_of(state);
    std::size_t moving = 0;
    bool far = false;
    for (const Vertex_move<d>& m : moves) {
        const double squared = squared_way(state, m);
        moving += squared > 0 ? 1 : 0;
        far = far || squared > spacing * spacing;
    }
    if (moving <= 1) return true;
    const double each = static_cast<double>(moving);
    const double all = n * (tolerances_.kept() ? Costs::tolerances : Costs::signs) +
                       (far ? small_build_in_box + n * Costs::build : each * Costs::flips);
    return each * Costs::reinsertion < all;
}

/// More would cost more than to compute all tolerances again.
template <int d>
std::size_t Periodic_mover<d>::most_failed(std::size_t vertices) const {
    constexpr double share = Cost_model<d>::recomputation / (4 * Cost_model<d>::failure);
    const auto most = static_cast<std::size_t>(std::min(1.0, share) * static_cast<double>(vertices));
    if (strategy_ == Periodic_strategy::tolerances) return most;
    std::size_t failed = most;
    while (failed > 0 && policy_.exceeds_budget(failed, vertices)) failed /= 2;
    return failed;
}

template <int d>
Move_result Periodic_mover<d>::move(Periodic_state<d>& state, Periodic_state<d> next) {
    const std::size_t n = next.vertices();
    const bool kept = tolerances_.kept();
    Budget budget{small_build_in_box + Periodic_costs<d>::copy * static_cast<double>(builder_.copies())};
    const Periodic_repair_result repaired = repair_.repair(
        state.table, {state.lattice, state.place}, {next.lattice, next.place}, budget, {tolerances_, most_failed(n)});
    Move_result result;
    const bool rests = repaired.done && !repair_.motion().moves();
    if (repaired.done) std::swap(next.table, state.table);
    else {
        tolerances_.invalidate();
        builder_.build(next.lattice, next.place, threads_, next.table);
        budget.charge(Periodic_costs<d>::copy * static_cast<double>(builder_.copies()));
    }
    if (repaired.done && !rests) consider(state, next, result.statistics);
    std::swap<Placed_points<d>>(spare_, state);
    state = std::move(next);
    builder_.end_step();
    result.moves.asked = n;
    result.moves.flipped = repaired.flipped;
    if (!repaired.done) result.moves.rebuilt = n;
    else if (!repaired.by_tolerances) result.moves.kept_in_place = n - repaired.flipped;
    else {
        result.moves.kept_in_place = repaired.failed;
        result.moves.within_tolerance = n - repaired.flipped - repaired.failed;
        result.statistics.star_walks = tolerances_.star_walks();
    }
    result.statistics.flips = repaired.flips;
    result.statistics.evaluated += repaired.evaluated.total();
    result.statistics.arithmetic += repaired.evaluated;
    result.statistics.cost = budget.spent;
    if (rests) return result;
    ++(repaired.by_tolerances ? result.statistics.tolerance_steps : result.statistics.sign_steps);
    finish(state, kept, repaired, result.statistics);
    return result;
}

/// A step without tolerances: whether they would have paid, now and then. Nothing but the next decision depends on it.
template <int d>
void Periodic_mover<d>::consider(const Periodic_state<d>& before, const Periodic_state<d>& after,
                                 Move_statistics& statistics) {
    if (strategy_ != Periodic_strategy::automatic || tolerances_.kept() || !policy_.is_time_to_check()) return;
    try {
        const Periodic_view<d> view{after.table, after.lattice, after.place};
        policy_.decide(in_periodic_box * Periodic_tolerances<d>::expected_share(view, repair_.motion(), before.lattice,
                                                                                spacing_of(after), statistics),
                       false);
    } catch (const std::bad_alloc&) {  // undecided
    }
}

/// Tolerances that were kept and are not any more, though few of them failed, have to be computed again: of a box that
/// has another shape by now, or another basis, or of long paths.
template <int d>
void Periodic_mover<d>::finish(const Periodic_state<d>& state, bool kept_before, const Periodic_repair_result& done,
                               Move_statistics& statistics) {
    const std::size_t n = state.vertices();
    if (strategy_ == Periodic_strategy::signs || n == 0) return;
    bool again = strategy_ == Periodic_strategy::tolerances && !tolerances_.kept();
    if (strategy_ == Periodic_strategy::automatic) {
        const bool failed = tolerances_.failed().size() > 0 && !done.by_tolerances;
        if (done.by_tolerances) {
            const auto in_box = static_cast<std::size_t>(in_periodic_box);
            policy_.note_step(in_box * tolerances_.failed().size(), in_box * done.evaluated.total());
            (void)policy_.end_step_with_tolerances(false, n);
        } else if (!kept_before) policy_.note_step_without_tolerances();
        if (kept_before && !tolerances_.kept()) {
            again = done.done && !failed && policy_.renews(n);
            if (!again) policy_.note_dropped();
        } else if (!kept_before && policy_.take_recomputation()) {
            again = true;
            policy_.note_recomputed();
        }
    }
    if (!again) {
        if (!tolerances_.kept()) tolerances_.drop();
        return;
    }
    try {
        evaluate_all(state, statistics);
    } catch (const std::bad_alloc&) {  // the step has been made, and the next one tests all signs
        tolerances_.drop();
    }
}

template <int d>
void Periodic_mover<d>::evaluate_all(const Periodic_state<d>& state, Move_statistics& statistics) {
    const Stage_counts counts = tolerances_.recompute({state.table, state.lattice, state.place}, spacing_of(state));
    statistics.evaluated += counts.total();
    statistics.arithmetic += counts;
    statistics.cost += Cost_model<d>::recomputation * static_cast<double>(state.vertices());
    ++statistics.tolerance_recomputations;
}

template <int d>
void Periodic_mover<d>::recompute(const Periodic_state<d>& state, Move_statistics& statistics) {
    if (strategy_ == Periodic_strategy::signs || state.vertices() == 0) return;
    evaluate_all(state, statistics);
    policy_.note_recomputed();
}

template <int d>
std::vector<double> Periodic_mover<d>::tolerances(const Periodic_state<d>& state) const {
    const Periodic_view<d> view{state.table, state.lattice, state.place};
    return tolerances_.kept() ? tolerances_.left(view) : Periodic_tolerances<d>::evaluate(view, threads_);
}

template class Periodic_mover<2>;
template class Periodic_mover<3>;

}  // namespace annulus::inline v1
