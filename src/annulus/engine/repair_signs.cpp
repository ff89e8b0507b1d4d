// SPDX-License-Identifier: GPL-3.0-or-later
// Signs alone: for when tolerances would not last.
#include <annulus/engine/repair.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace annulus {

/// Leaves on the lists what does not hold.
template <int d>
bool Repair<d>::signs_hold(double most) {
    const auto& t = mesh_.table();
    auto& signs = mender_.signs();
    signs_ = true;
    // So far beyond what it may cost that asking all of them would only make it dearer.
    constexpr double margin = 1.5;
    hopeless_ = std::isfinite(most) && signs.price() + signs.outlook() > margin * most;
    if (hopeless_) {
        count_signs();
        return false;
    }
    const auto affordable = [&] { return signs.price() <= most; };
    std::erase_if(signs.inverted(), [&](Cell_index c) { return affordable() && !signs.is_inverted(c); });
    std::erase_if(signs.violated(), [&](Corner_index f) { return affordable() && !signs.is_violated(f); });
    for (const Cell_index c : signs.inverted())
        for (const Index v : cell_points(t, c)) disturbed_.push_back(v);
    for (const Corner_index f : signs.violated()) note_disturbed(facet_certificate(t, f, false).point);
    count_signs();
    if (!signs.inverted().empty() || !signs.violated().empty()) return false;
    return border_holds();
}

template <int d>
bool Repair<d>::evaluate_everything(double most) {
    mender_.signs().look_at_everything();
    return signs_hold(most);
}

template <int d>
bool Repair<d>::evaluate_star(Index v) {
    mender_.signs().look_around(v, false);
    return signs_hold(std::numeric_limits<double>::infinity());
}

/// What the mender asked since it was counted last.
template <int d>
void Repair<d>::count_signs() {
    const Stage_counts all = mender_.signs().counts();
    report_.evaluated += all.total() - counted_.total();
    report_.arithmetic.filter += all.filter - counted_.filter;
    report_.arithmetic.interval += all.interval - counted_.interval;
    report_.arithmetic.exact += all.exact - counted_.exact;
    counted_ = all;
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
