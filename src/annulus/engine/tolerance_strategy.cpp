// SPDX-License-Identifier: GPL-3.0-or-later
// A step of `tolerances`: which vertices failed, and what became of them.
#include <annulus/engine/tolerance_strategy.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/engine/trace.h>
#include <annulus/error.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

/// Of vertices [first, last): those that left their tolerances or, without tolerances, those that move. False when a
/// coordinate is outside the domain, even at a free index.
template <int d>
bool Tolerance_strategy<d>::find_failed(Step<d>& step, std::size_t first, std::size_t last,
                                        std::vector<Index>& failed) const {
    const auto x = step.x;
    if (displacement_budget_.kept()) return displacement_budget_.find_failed(x, first, last, failed);
    bool near = true;
    for (std::size_t v = first; v < last; ++v) {
        // No branch: this runs over all positions.
        for (const double c : x[v]) near &= std::fabs(c) <= coordinate_limit;
        if (x[v] != position_[v] && table_.corner_of(static_cast<Index>(v)) != no_corner)
            failed.push_back(static_cast<Index>(v));
    }
    return near;
}

template <int d>
bool Tolerance_strategy<d>::find_failed(Step<d>& step) const {
    constexpr std::size_t run = 1U << 15;
    const std::size_t n = step.x.size();
    if (threads_ == 1 || n <= run) return find_failed(step, 0, n, step.failed);
    std::vector<std::vector<Index>> failed((n + run - 1) / run);
    std::vector<char> near(failed.size());
    for_each_run(n, run, threads_, [&](std::size_t first, std::size_t last) {
        near[first / run] = find_failed(step, first, last, failed[first / run]) ? 1 : 0;
    });
    for (const auto& here : failed) step.failed.insert(step.failed.end(), here.begin(), here.end());
    return std::find(near.begin(), near.end(), 0) == near.end();
}

/// Positions at free indices do not count.
template <int d>
void Tolerance_strategy<d>::require_domain(std::span<const Coordinates<d>> x) const {
    require_in_domain(x, "vertex", [this](std::size_t v) { return is_present(v) ? static_cast<Index>(v) : none; });
}

/// Whether finding what expired would already cost a good part of what repair may cost.
template <int d>
bool Tolerance_strategy<d>::too_many_failed(const Step<d>& step) const {
    return tolerance_policy_.exceeds_budget(step.failed.size(), mesh_.vertices()) ||
           Cost_model<d>::failure * static_cast<double>(step.failed.size()) > 0.25 * step.budget.limit;
}

template <int d>
void Tolerance_strategy<d>::move(Index v, const Coordinates<d>& p, Move_result& report) {
    if (displacement_budget_.kept() || means_ == Means::signs ||
        (!slices_.begun() && !tolerance_policy_.recomputes_for_single_move(table_, repair_.checker(), position_,
                                                                           mesh_.vertices(), report))) {
        stop_rebuilding();
        const std::uint64_t calm = report.moves.kept_in_place + report.moves.within_tolerance;
        move_one(v, p, report);
        if (displacement_budget_.kept()) {
            if (tolerance_policy_.end_single_move(mesh_.vertices())) drop_tolerances();
        } else {
            tolerance_policy_.note_single_move(report.moves.kept_in_place + report.moves.within_tolerance > calm);
        }
        return;
    }
    recompute_tolerances(position_, report);
    try {
        move_one(v, p, report);
    } catch (...) {
        drop_tolerances();
        throw;
    }
}

template <int d>
void Tolerance_strategy<d>::move_one(Index v, const Coordinates<d>& p, Move_result& report) {
    if (displacement_budget_.kept() ? displacement_budget_.passes(v, p) : p == position_[at(v)]) {
        position_[at(v)] = p;
        ANNULUS_TRACED(passed(displacement_budget_, v, p));
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    const Coordinates<d> old = std::exchange(position_[at(v)], p);
    Step<d> step = new_step(position_, v, displacement_budget_.kept() ? Scope::expired : Scope::star);
    try {
        step.source = old;
        step.failed.push_back(v);
        ANNULUS_TRACED(tested(displacement_budget_, step));
        step.budget.limit = Rebuild_policy<d>::generous_repair_limit(mesh_.vertices());
        process(
            step, [&] { return repair_.repair_one(step, position_); }, report);
    } catch (const Error& e) {
        position_[at(v)] = old;
        if (e.code() == Error_code::duplicate_point) renew_renumbered(step);
        throw;
    } catch (...) {
        position_[at(v)] = old;
        throw;
    }
}

template <int d>
void Tolerance_strategy<d>::move_all(std::span<const Coordinates<d>> x, Move_result& report) {
    if (rebuilding_) {
        require_domain(x);
        ANNULUS_TRACED(untracking(displacement_budget_));
        rebuild_all(x, next_is_repaired(x), report);
        return;
    }
    Step<d> step = new_step(x, none, Scope::expired);
    if (!find_failed(step)) require_domain(x);
    ANNULUS_TRACED(tested(displacement_budget_, step));
    if (!step.failed.empty()) step.budget.limit = repair_limit();
    if (!displacement_budget_.kept() || too_many_failed(step)) step.scope = Scope::everything;
    note_displacements(x);
    if (step.failed.empty()) {
        report.moves.asked += mesh_.vertices();
        report.moves.within_tolerance += mesh_.vertices();
        std::copy(x.begin(), x.end(), position_.begin());
        previous_ = std::move(step);
    } else {
        try {
            process(
                step, [&] { return repair_.repair_all(step, position_); }, report);
        } catch (const Error& e) {
            if (e.code() == Error_code::duplicate_point) renew_renumbered(step);
            throw;
        }
    }
    if (rebuilding_) return;
    if (!displacement_budget_.kept()) recompute_afterwards(report);
    end_step(false, report);
}

/// Whether everything holds. When so many certificates have expired that their tolerances would cost more than repair
/// may, signs are evaluated instead.
template <int d>
bool Tolerance_strategy<d>::examine(Step<d>& step) {
    repair_.begin(step);
    if (step.scope == Scope::star) return repair_.evaluate_star(step);
    if (step.scope == Scope::expired) {
        displacement_budget_.find_expired(step, repair_.checker());
        step.budget.charge(Cost_model<d>::failure * static_cast<double>(step.failed.size()));
        if (step.mover != none || repair_.can_evaluate(step, 0.5 * step.budget.limit)) return repair_.evaluate(step);
        displacement_budget_.undo(step);
        step.scope = Scope::everything;
        step.budget.later_stages = 0.0;  // of tolerances
        repair_.begin(step);
    }
    return repair_.evaluate_everything(step);
}

/// Examines, repairs and commits. Positions are written last, so that a handler of an exception can rebuild at the
/// previous ones; a duplicate point is found before anything is committed.
template <int d>
template <class Repair_call>
void Tolerance_strategy<d>::process(Step<d>& step, Repair_call repair, Move_result& report) {
    try {
        if (!examine(step) && !repair()) {
            step.budget.charge(Rebuild_policy<d>::rebuild_cost(mesh_.vertices()));
            rebuild(step);
            step.rebuilt = true;
        }
    } catch (...) {
        if (step.scope == Scope::expired && displacement_budget_.kept()) displacement_budget_.undo(step);
        throw;
    }
    finish(step, report);
    previous_ = std::move(step);
}

template <int d>
void Tolerance_strategy<d>::finish(Step<d>& step, Move_result& report) {
    const bool tolerances = step.scope == Scope::expired;
    const bool alone = step.mover != none;
    report += step.report;
    report.statistics.cost += step.budget.spent;
    report.statistics.star_walks += step.star_walks;
    if (!alone) ++(tolerances ? report.statistics.tolerance_steps : report.statistics.sign_steps);
    if (tolerances) tolerance_policy_.note_step(step.failed.size(), step.report.statistics.evaluated);
    outcomes_.count(step, alone ? 1 : mesh_.vertices(), report.moves);
    const bool too_expensive = means_ == Means::any && !alone && !step.rebuilt &&
                               step.budget.spent > Rebuild_policy<d>::rebuild_cost(mesh_.vertices());
    if (!step.rebuilt) {
        if (!alone && !too_expensive) rebuild_policy_.repaired();
        if (slices_.begun()) slices_.note_changed(repair_.touched());
        if (tolerances) displacement_budget_.commit(step, repair_.checker());
    }
    if (displacement_budget_.kept() && (step.scope == Scope::everything || step.rebuilt)) drop_tolerances();
    if (too_expensive) rebuild_from_now_on();
    if (!displacement_budget_.kept() && !alone) tolerance_policy_.note_step_without_tolerances();
    if (!displacement_budget_.kept()) release(step.before);
    if (step.x.data() != position_.data()) std::copy(step.x.begin(), step.x.end(), position_.begin());
}

/// After a duplicate point, when cells have other numbers than those in the records.
template <int d>
void Tolerance_strategy<d>::renew_renumbered(const Step<d>& step) {
    Move_result discarded;
    if (step.renumbered_all && displacement_budget_.kept()) recompute_tolerances(position_, discarded);
    else if (!step.renumbered.empty()) refresh(step.renumbered, discarded);
}

template class Tolerance_strategy<2>;
template class Tolerance_strategy<3>;

}  // namespace annulus::inline v1
