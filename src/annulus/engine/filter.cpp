// SPDX-License-Identifier: GPL-3.0-or-later
// A step of `filter`: who failed, what became of it.
#include <annulus/engine/filter.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/error.h>
#include <annulus/engine/trace.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>

namespace annulus {

/// Of vertices [first, last): those that left their tolerances, or, without tolerances, that move. False when a coordinate is outside
/// the domain, be it at a vacant index.
template <int d>
bool Filter<d>::find_failed(Step<d>& step, std::size_t first, std::size_t last, std::vector<Index>& failed) const {
    const auto x = step.x;
    if (odometers_.kept()) return odometers_.find_failed(x, first, last, failed);
    bool near = true;
    for (std::size_t v = first; v < last; ++v) {
        for (const double c : x[v]) near &= std::fabs(c) <= coordinate_limit;  // no branch: this runs over all positions
        if (x[v] != position_[v] && table_.corner_of(static_cast<Index>(v)) != no_corner) failed.push_back(static_cast<Index>(v));
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
    if (repair_.kind() == Tolerance_kind::paper) return false;
    return tracking_.is_too_dear(step.failed.size(), mesh_.vertices()) ||
           Prices<d>::failure * static_cast<double>(step.failed.size()) > 0.25 * step.most;
}

template <int d>
void Filter<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    if (odometers_.kept() || means_ == Means::signs || !tracking_.settles_for_single_move(mesh_.vertices())) {
        stop_rebuilding();
        move_one(v, p, report);
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
    const Coordinates<d> old = position_[at(v)];
    try {
        position_[at(v)] = p;
        Step<d> step = new_step(position_, v, odometers_.kept() ? Scope::expired : Scope::star);
        step.home = old;
        step.failed.push_back(v);
        ANNULUS_TRACED(tested(odometers_, step));
        step.most = Chooser<d>::most_generous_repair(mesh_.vertices());
        process(step, [&] { return repair_.mend_one(position_, v, old, step.most); }, report);
    } catch (const Error& e) {
        position_[at(v)] = old;
        if (e.code() == Error_code::collision) renew_renumbered();
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
    if (!step.failed.empty()) step.most = most_repair();
    if (!odometers_.kept() || too_many_failed(step)) step.scope = Scope::everything;
    note_displacements(x);
    if (step.failed.empty()) {
        report.moves.asked += mesh_.vertices();
        report.moves.within_tolerance += mesh_.vertices();
        std::copy(x.begin(), x.end(), position_.begin());
        over_ = std::move(step);
    } else {
        try {
            process(step, [&] { return repair_.mend_all(position_, step.most - dearer(step)); }, report);
        } catch (const Error& e) {
            if (e.code() == Error_code::collision) renew_renumbered();
            throw;
        }
    }
    if (rebuilding_) return;
    if (!odometers_.kept()) settle_afterwards(report);
    end_timestamp(false, report);
}

/// What this step cost so far besides the signs that repair asked, in cells looked at.
template <int d>
double Filter<d>::dearer(const Step<d>& step) const {
    if (repair_.kind() == Tolerance_kind::paper) return 0.0;
    return step.prepared + repair_.evaluation_price();
}

/// Whether everything holds. When so many certificates have expired that their tolerances would cost more than repair may, signs are
/// asked instead.
template <int d>
bool Filter<d>::examine(Step<d>& step) {
    const bool alone = step.mover != none;
    repair_.begin(step.x, !alone);
    if (step.scope == Scope::star) return repair_.evaluate_star(step.mover);
    if (step.scope == Scope::expired) {
        odometers_.find_expired(step, repair_);
        step.prepared += Prices<d>::failure * static_cast<double>(step.failed.size());
        if (alone || repair_.kind() == Tolerance_kind::paper || repair_.price() + dearer(step) <= 0.5 * step.most)
            return repair_.evaluate();
        odometers_.undo(step);
        step.renewals.clear();
        step.scope = Scope::everything;
        repair_.begin(step.x, true);
    }
    return repair_.evaluate_everything(step.most - step.prepared);
}

/// Examines, mends and commits. Positions are written last, so that whoever meets an exception on the way can build anew at them; a
/// collision is met before anything is committed.
template <int d>
template <class Mend>
void Filter<d>::process(Step<d>& step, Mend mend, Move_report& report) {
    try {
        if (!examine(step) && !mend()) {
            step.rebuilding = Chooser<d>::rebuild_price(mesh_.vertices());
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
    report += repair_.report();
    report.price += repair_.price() + dearer(step) + step.rebuilding;
    report.renewed += step.renewals.size();
    report.tours += step.tours;
    if (!alone) ++(tolerances ? report.tolerance_steps : report.sign_steps);
    if (tolerances) tracking_.note_step(step.failed.size(), repair_.report().evaluated);
    outcomes_.count(step, repair_, alone ? 1 : mesh_.vertices(), report.moves);
    if (!step.rebuilt) {
        if (!alone) chooser_.mended();
        if (tolerances) odometers_.commit(step, repair_);
    }
    if (tolerances && step.rebuilt && repair_.kind() == Tolerance_kind::paper) {
        settle(step.x, report);
    } else if (odometers_.kept() && (step.scope == Scope::everything || step.rebuilt)) {
        stop_tracking();
    }
    if (!odometers_.kept() && !alone) tracking_.note_untracked();
    if (step.x.data() != position_.data()) std::copy(step.x.begin(), step.x.end(), position_.begin());
}

/// After a collision, when the cells have other numbers than those that records name.
template <int d>
void Filter<d>::renew_renumbered() {
    Move_report nobody_asked;
    if (renumbered_ && odometers_.kept()) settle(position_, nobody_asked);
    else if (!repair_.renumbered().empty()) {
        const std::vector<Cell_index> cells(repair_.renumbered().begin(), repair_.renumbered().end());
        refresh(cells, nobody_asked);
    }
    renumbered_ = false;
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
