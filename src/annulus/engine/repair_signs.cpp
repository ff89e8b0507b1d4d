// SPDX-License-Identifier: GPL-3.0-or-later
// Signs alone, for motions under which tolerances would not last.
#include <annulus/engine/rebuild_policy.h>
#include <annulus/engine/repair.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

/// Leaves on the lists what does not hold.
template <int d>
bool Repair<d>::signs_hold(Step<d>& step, double most) {
    const auto& t = mesh_.table();
    const Repair_estimate flips = std::isfinite(most) ? signs_.estimate() : Repair_estimate{};
    step.infeasible = step.budget.spent + Rebuild_policy<d>::expected(flips) > most;
    if (step.infeasible) {
        step.count(signs_.take_counts());
        return false;
    }
    // Signs that the filter leaves open may cost more than a rebuild, and so may flips among them: those that have been
    // evaluated tell.
    constexpr double evidence = 1.0 / 16.0, share = 0.6;  // of the limit
    const double before = step.budget.spent;
    const auto all = static_cast<double>(signs_.inverted().size() + signs_.violated().size());
    double evaluated = 0.0;
    const auto is_infeasible = [&] {
        const double cost = step.budget.spent - before;
        if (!(cost > evidence * most)) return false;
        const double signs = before + cost / evaluated * all;
        const double later_stages = step.budget.later_stages / evaluated * all;
        return signs > share * most || signs + Rebuild_policy<d>::expected(flips, later_stages, most) > most;
    };
    const auto goes_on = [&] {
        step.infeasible = step.infeasible || is_infeasible();
        ++evaluated;
        return !step.infeasible;
    };
    std::erase_if(signs_.inverted(), [&](Cell_index c) { return goes_on() && !signs_.is_inverted(c); });
    if (step.mover != none && goes_far(step.mover)) {
        step.count(signs_.take_counts());  // it is reinserted, and what it violates may take an exact evaluation
        return false;
    }
    std::erase_if(signs_.violated(), [&](Corner_index f) { return goes_on() && !signs_.is_violated(f); });
    for (const Cell_index c : signs_.inverted())
        for (const Index v : cell_vertices(t, c)) step.affected.push_back(v);
    for (const Corner_index f : signs_.violated())
        for (const auto& [v, label] : facet_certificate(t, f, false).point)
            if (v != none) step.affected.push_back(v);
    step.count(signs_.take_counts());
    if (!signs_.inverted().empty() || !signs_.violated().empty()) return false;
    return border_holds(step, step.mover == none, true);
}

template <int d>
bool Repair<d>::evaluate_everything(Step<d>& step) {
    signs_.test_all_cells();
    return signs_hold(step, step.budget.limit);
}

template <int d>
bool Repair<d>::evaluate_star(Step<d>& step) {
    signs_.test_star(step.mover, false);
    return signs_hold(step, std::numeric_limits<double>::infinity());
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus::inline v1
