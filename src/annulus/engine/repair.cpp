// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/repair.h>

#include <annulus/engine/cost_model.h>
#include <annulus/engine/rebuild_policy.h>
#include <annulus/engine/reinsertion_cost.h>
#include <annulus/error.h>
#include <annulus/mesh/at.h>
#include <annulus/mesh/border.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <class Points>
void append_vertices(const Points& points, std::vector<Index>& vertices) {
    for (const auto& [v, label] : points)
        if (v != none) vertices.push_back(v);
}

/// What the stages after the filter cost to decide the signs of these values.
template <int d>
double later_stages(const Stage_counts& evaluated) {
    return Cost_model<d>::interval * static_cast<double>(evaluated.interval) +
           Cost_model<d>::exact * static_cast<double>(evaluated.exact);
}

}  // namespace

template <int d>
void Repair<d>::begin(Step<d>& step) {
    step.clear_findings();
    checker_.begin(step.x);
    signs_.begin(step.x, step.budget);
    flip_repair_.begin();
}

template <int d>
void Repair<d>::count(Step<d>& step, const Stage_counts& evaluated) {
    step.count(evaluated);
    step.budget.charge(Certificate_checker<d>::cost(evaluated));
    step.budget.later_stages += later_stages<d>(evaluated);
}

/// Where a mover has turned cells over, the tolerances of their facets cost an exact evaluation each and are not used:
/// signs come first.
template <int d>
bool Repair<d>::evaluate(Step<d>& step) {
    if (step.mover != none) {
        for (const auto& s : checker_.cells())
            if (signs_.is_inverted(s.id)) signs_.inverted().push_back(s.id);
        step.count(signs_.take_counts());
        if (goes_far(step.mover)) return false;
        signs_.inverted().clear();
    }
    count(step, checker_.evaluate());
    return checker_.all_hold() && border_holds(step, step.mover == none, false);
}

/// A few of them, taken from all over the mesh, tell what the stages after the filter are going to cost: no more than
/// there is room for if all of these are decided exactly.
template <int d>
bool Repair<d>::can_evaluate(Step<d>& step, double most) {
    if (step.budget.spent + checker_.pending_cost() > most) return false;
    const double few = std::clamp((most - step.budget.spent) / exact_evaluation_cost, 1.0, 16.0);
    const std::size_t stride = std::max<std::size_t>(1, checker_.size() / static_cast<std::size_t>(few));
    const Stage_counts some = checker_.evaluate_some(stride);
    count(step, some);
    const double later = Certificate_checker<d>::later_cost(some);
    return later == 0.0 || step.budget.spent + checker_.pending_cost() + static_cast<double>(stride) * later <= most;
}

template <int d>
bool Repair<d>::border_holds(Step<d>& step, bool many, bool by_signs) {
    const auto is_ridge = [](const auto& s) { return s.kind == Facet_kind::ridge; };
    const bool in_doubt = by_signs || (d == 2 && !checker_.cells().empty()) ||
                          std::any_of(checker_.facets().begin(), checker_.facets().end(), is_ridge);
    if (!many || !in_doubt) return true;
    std::size_t seen = 0;
    const bool holds = border_winds_once(mesh_.table(), step.x, seen);
    step.budget.charge(Cost_model<d>::border * static_cast<double>(seen));
    return holds;
}

/// Passes what does not hold to Flip_repair.
template <int d>
void Repair<d>::collect_violated(Step<d>& step) {
    for (const auto& s : checker_.cells()) {
        if (!checker_.is_violated(s)) continue;
        signs_.inverted().push_back(s.id);
        append_vertices(s.point, step.affected);
    }
    for (const auto& s : checker_.facets()) {
        if (s.kind == Facet_kind::nothing || s.value.sign > 0) continue;
        signs_.violated().push_back(s.id);
        if (s.kind == Facet_kind::empty_sphere && s.value.sign == 0) continue;  // degenerate, not violated yet
        append_vertices(s.point, step.affected);
    }
}

template <int d>
bool Repair<d>::repair_all(Step<d>& step, std::span<const Coordinates<d>> old) {
    std::vector<Coordinates<d>> trial(step.x.begin(), step.x.end());
    return repair(step, {trial, old});
}

template <int d>
bool Repair<d>::repair_one(Step<d>& step, std::span<Coordinates<d>> x) {
    Budget& budget = step.budget;
    if (!goes_far(step.mover)) {
        // Otherwise reinsertion finds the other vertex, or the rebuild does.
        if (is_occupied(step)) throw Error(Error_code::duplicate_point, "another vertex is at that position");
        const double limit =
            std::exchange(budget.limit, std::min(budget.limit, budget.spent + Cost_model<d>::reinsertion));
        const bool repaired = repair(step, {x, {}, step.mover, step.source});
        budget.limit = limit;
        if (repaired) return true;
    }
    const Coordinates<d> target = std::exchange(x[at(step.mover)], step.source);
    const std::vector<Cell_index>& touched = flip_repair_.result().touched;
    mesh_.restore_cells(x, touched, step.renumbered);
    budget.charge(Cost_model<d>::flip * static_cast<double>(touched.size()));
    const double cost = reinsertion_cost(mesh_.table(), step.mover);
    if (cost <= Rebuild_policy<d>::generous_rebuild_limit(mesh_.vertices()) && reinsert(step, x, target, cost))
        return true;
    x[at(step.mover)] = target;
    return false;
}

/// Whether so many cells of the mover are inverted at its target that holding back and flips would cost more than
/// reinsertion, and lead nowhere half of the time. Precondition: the inverted ones, or none, are on the list.
template <int d>
bool Repair<d>::goes_far(Index mover) const {
    constexpr double share = d == 2 ? 0.3 : 0.25;
    return Cost_model<d>::inverted * static_cast<double>(signs_.inverted().size()) >
           share * reinsertion_cost(mesh_.table(), mover);
}

template <int d>
bool Repair<d>::reinsert(Step<d>& step, std::span<Coordinates<d>> x, const Coordinates<d>& target, double cost) {
    const auto gone = [this](Cell_index c) { return !mesh_.table().is_cell(c); };
    std::vector<Cell_index> changed;
    try {
        if (!mesh_.reinsert(x, step.mover, target, changed)) return false;
    } catch (const Error&) {
        step.renumbered.insert(step.renumbered.end(), changed.begin(), changed.end());
        std::erase_if(step.renumbered, gone);
        throw;
    }
    step.budget.charge(cost);
    changed.insert(changed.end(), step.renumbered.begin(), step.renumbered.end());
    std::erase_if(changed, gone);
    step.reinserted.assign(1, step.mover);
    checker_.clear();  // what was evaluated before may have another certificate's number by now
    // Without tolerances all others are where the mesh is Delaunay, as when a vertex is inserted, and nothing is
    // written down.
    const bool with_tolerances = step.scope == Scope::expired;
    if (!with_tolerances) return true;
    checker_.add_cells(changed);
    checker_.add_star(step.mover);
    count(step, checker_.evaluate());
    return checker_.all_hold() && border_holds(step, true, false);
}

template <int d>
bool Repair<d>::repair(Step<d>& step, const Motion_path<d>& path) {
    if (step.infeasible || !step.budget.within_limit()) return false;
    if (step.scope == Scope::expired) collect_violated(step);
    checker_.note_changes();
    const double limit = step.budget.limit;
    if (step.mover == none) {
        const Repair_estimate estimate = signs_.estimate();
        if (step.budget.spent + Rebuild_policy<d>::expected(estimate, step.budget.later_stages, limit) > limit)
            return false;
        step.budget.limit =
            std::min(limit, step.budget.spent + Rebuild_policy<d>::flips_limit(estimate, step.budget.spent, limit));
    }
    const Repair_result& result = flip_repair_.repair(path, step.budget);
    step.budget.limit = step.mover == none ? std::max(limit, Rebuild_policy<d>::late_limit(mesh_.vertices())) : limit;
    step.count(signs_.take_counts());
    if (!result.done || !holds_after_flips(step, result)) {
        step.report.statistics.undone_flips += result.flips;
        return false;
    }
    step.report.statistics.flips += result.flips;
    step.reinserted = result.reinserted;
    return true;
}

template <int d>
bool Repair<d>::holds_after_flips(Step<d>& step, const Repair_result& result) {
    const auto& t = mesh_.table();
    std::vector<Cell_index> alive;
    std::copy_if(result.touched.begin(), result.touched.end(), std::back_inserter(alive),
                 [&t](Cell_index c) { return t.is_cell(c); });
    // Even a single mover may have passed over a part of the hull that its cells do not touch.
    const bool at_border = std::any_of(alive.begin(), alive.end(), [&t](Cell_index c) { return t.is_infinite(c); });
    const bool many = step.mover == none || at_border;
    if (at_border && result.cells_rebuilt && !border_is_whole(t)) return false;
    if (step.scope != Scope::expired) return border_holds(step, many, true);
    // Their tolerances cost something, too, and what later stages cost is not known beforehand.
    const std::size_t chunk = std::max(alive.size() / 16, std::size_t{128});
    for (std::span<const Cell_index> left(alive); !left.empty();) {
        const std::size_t facets = checker_.facets().size();
        const std::size_t cells = checker_.cells().size();
        checker_.add_cells(left.first(std::min(chunk, left.size())));
        left = left.subspan(std::min(chunk, left.size()));
        if (left.empty()) break;
        // Only the new ones; older entries that have become stale again come last.
        count(step, checker_.evaluate_from(facets, cells));
        if (!step.budget.within_limit()) return false;
    }
    count(step, checker_.evaluate());
    return checker_.all_hold() && border_holds(step, many, false);
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus::inline v1
