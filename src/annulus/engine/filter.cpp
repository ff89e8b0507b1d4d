// SPDX-License-Identifier: GPL-3.0-or-later
// A step of `filter`: who failed, what became of it.
#include <annulus/engine/filter.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/error.h>
#include <annulus/engine/trace.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <utility>

namespace annulus {

/// Of vertices [first, last): those that left their tolerances, or, without tolerances, that move. False when a
/// coordinate is outside the domain, be it at a vacant index.
template <int d>
bool Filter<d>::find_failed(Step<d>& step, std::size_t first, std::size_t last, std::vector<Index>& failed) const {
    const auto x = step.x;
    if (odometers_.kept()) return odometers_.find_failed(x, first, last, failed);
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
bool Filter<d>::find_failed(Step<d>& step) const {
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

/// What stands at a vacant index does not count.
template <int d>
void Filter<d>::require_domain(std::span<const Coordinates<d>> x) const {
    for (std::size_t v = 0; v < x.size(); ++v)
        if (lives(v)) require_in_domain(x[v], "vertex", static_cast<Index>(v));
}

/// Whether looking for what expired would already cost a good part of what repair may.
template <int d>
bool Filter<d>::too_many_failed(const Step<d>& step) const {
    return tracking_.is_too_dear(step.failed.size(), mesh_.vertices()) ||
           Prices<d>::failure * static_cast<double>(step.failed.size()) > 0.25 * step.budget.limit;
}

template <int d>
void Filter<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    if (odometers_.kept() || means_ == Means::signs || !tracking_.settles_for_single_move(mesh_.vertices())) {
        stop_rebuilding();
        const std::uint64_t calm = report.moves.kept_in_place + report.moves.within_tolerance;
        move_one(v, p, report);
        if (odometers_.kept()) {
            if (tracking_.end_single(mesh_.vertices())) stop_tracking();
        } else {
            tracking_.note_single(report.moves.kept_in_place + report.moves.within_tolerance > calm);
        }
        return;
    }
    settle(position_, report);
    try {
        move_one(v, p, report);
    } catch (...) {
        stop_tracking();
        throw;
    }
}

template <int d>
void Filter<d>::move_one(Index v, const Coordinates<d>& p, Move_report& report) {
    if (odometers_.kept() ? odometers_.passes(v, p) : p == position_[at(v)]) {
        position_[at(v)] = p;
        ANNULUS_TRACED(passed(odometers_, v, p));
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    const Coordinates<d> old = std::exchange(position_[at(v)], p);
    Step<d> step = new_step(position_, v, odometers_.kept() ? Scope::expired : Scope::star);
    try {
        step.home = old;
        step.failed.push_back(v);
        ANNULUS_TRACED(tested(odometers_, step));
        step.budget.limit = Chooser<d>::most_generous_repair(mesh_.vertices());
        process(
            step, [&] { return repair_.mend_one(step, position_); }, report);
    } catch (const Error& e) {
        position_[at(v)] = old;
        if (e.code() == Error_code::collision) renew_renumbered(step);
        throw;
    } catch (...) {
        position_[at(v)] = old;
        throw;
    }
}

template <int d>
void Filter<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    if (rebuilding_) {
        require_domain(x);
        ANNULUS_TRACED(untracking(odometers_));
        rebuild_all(x, next_is_mended(x), report);
        return;
    }
    Step<d> step = new_step(x, none, Scope::expired);
    if (!find_failed(step)) require_domain(x);
    ANNULUS_TRACED(tested(odometers_, step));
    if (!step.failed.empty()) step.budget.limit = most_repair();
    if (!odometers_.kept() || too_many_failed(step)) step.scope = Scope::everything;
    note_displacements(x);
    if (step.failed.empty()) {
        report.moves.asked += mesh_.vertices();
        report.moves.within_tolerance += mesh_.vertices();
        std::copy(x.begin(), x.end(), position_.begin());
        over_ = std::move(step);
    } else {
        try {
            process(
                step, [&] { return repair_.mend_all(step, position_); }, report);
        } catch (const Error& e) {
            if (e.code() == Error_code::collision) renew_renumbered(step);
            throw;
        }
    }
    if (rebuilding_) return;
    if (!odometers_.kept()) settle_afterwards(report);
    end_timestamp(false, report);
}

/// Whether everything holds. When so many certificates have expired that their tolerances would cost more than repair
/// may, signs are asked instead.
template <int d>
bool Filter<d>::examine(Step<d>& step) {
    repair_.begin(step);
    if (step.scope == Scope::star) return repair_.evaluate_star(step);
    if (step.scope == Scope::expired) {
        odometers_.find_expired(step, repair_.checker());
        step.budget.charge(Prices<d>::failure * static_cast<double>(step.failed.size()));
        const double price = step.budget.spent + repair_.checker().pending_price();
        if (step.mover != none || price <= 0.5 * step.budget.limit) return repair_.evaluate(step);
        odometers_.undo(step);
        step.scope = Scope::everything;
        repair_.begin(step);
    }
    return repair_.evaluate_everything(step);
}

/// Examines, mends and commits. Positions are written last, so that whoever meets an exception on the way can build
/// anew at them; a collision is met before anything is committed.
template <int d>
template <class Mend>
void Filter<d>::process(Step<d>& step, Mend mend, Move_report& report) {
    try {
        if (!examine(step) && !mend()) {
            step.budget.charge(Chooser<d>::rebuild_price(mesh_.vertices()));
            rebuild(step);
            step.rebuilt = true;
        }
    } catch (...) {
        if (step.scope == Scope::expired && odometers_.kept()) odometers_.undo(step);
        throw;
    }
    finish(step, report);
    over_ = std::move(step);
}

template <int d>
void Filter<d>::finish(Step<d>& step, Move_report& report) {
    const bool tolerances = step.scope == Scope::expired;
    const bool alone = step.mover != none;
    report += step.report;
    report.price += step.budget.spent;
    report.tours += step.tours;
    if (!alone) ++(tolerances ? report.tolerance_steps : report.sign_steps);
    if (tolerances) tracking_.note_step(step.failed.size(), step.report.evaluated);
    outcomes_.count(step, alone ? 1 : mesh_.vertices(), report.moves);
    if (!step.rebuilt) {
        if (!alone) chooser_.mended();
        if (tolerances) odometers_.commit(step, repair_.checker());
    }
    if (odometers_.kept() && (step.scope == Scope::everything || step.rebuilt)) stop_tracking();
    if (!odometers_.kept() && !alone) tracking_.note_untracked();
    if (step.x.data() != position_.data()) std::copy(step.x.begin(), step.x.end(), position_.begin());
}

/// After a collision, when cells have other numbers than those that records name.
template <int d>
void Filter<d>::renew_renumbered(const Step<d>& step) {
    Move_report nobody_asked;
    if (step.renumbered_all && odometers_.kept()) settle(position_, nobody_asked);
    else if (!step.renumbered.empty()) refresh(step.renumbered, nobody_asked);
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
