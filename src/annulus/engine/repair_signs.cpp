// SPDX-License-Identifier: GPL-3.0-or-later
// Signs alone, for motions under which tolerances would not last.
#include <annulus/engine/repair.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus::inline v1 {

/// Leaves on the lists what does not hold.
template <int d>
bool Repair<d>::signs_hold(Step<d>& step, double most) {
    const auto& t = mesh_.table();
    // So far above the limit, evaluating all of them would only add to the cost.
    constexpr double margin = 1.5;
    step.infeasible = std::isfinite(most) && step.budget.spent + signs_.estimate() > margin * most;
    if (step.infeasible) {
        step.count(signs_.take_counts());
        return false;
    }
    const auto within_limit = [&] { return step.budget.spent <= most; };
    std::erase_if(signs_.inverted(), [&](Cell_index c) { return within_limit() && !signs_.is_inverted(c); });
    std::erase_if(signs_.violated(), [&](Corner_index f) { return within_limit() && !signs_.is_violated(f); });
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
