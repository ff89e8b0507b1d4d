// SPDX-License-Identifier: GPL-3.0-or-later
// What became of the vertices that were asked to move.
#include <annulus/engine/filter.h>

#include <algorithm>

namespace annulus {

template <int d>
void Filter<d>::count(Index mover, bool rebuilt, Move_report& report) {
    const std::size_t asked = mover == none ? embedding_.vertices() : 1;
    report.moves.asked += asked;
    if (rebuilt) {
        report.moves.rebuilt += asked;
        return;
    }
    if (step_ >= Horizons::stamps - 3) {  // the sum would wrap before it was compared
        std::fill(disturbed_stamp_.begin(), disturbed_stamp_.end(), 0);
        step_ = 0;
    }
    step_ += 2;  // its mark, and the one above it
    std::size_t left = asked;
    const auto once = [this](Index v) {
        if (disturbed_stamp_[at(v)] == step_) return false;
        disturbed_stamp_[at(v)] = step_;
        return true;
    };
    for (const Index v : repair_.reinserted()) {
        if ((mover != none && v != mover) || !once(v)) continue;
        ++report.moves.reinserted;
        --left;
    }
    // Marks the disturbed that are not reinserted; those of them that failed were flipped.
    for (const Index v : repair_.disturbed())
        if (disturbed_stamp_[at(v)] != step_) disturbed_stamp_[at(v)] = step_ + 1;
    for (const Index v : failed_) {
        const std::uint32_t stamp = disturbed_stamp_[at(v)];
        if (stamp == step_) continue;
        ++(stamp == step_ + 1 ? report.moves.flipped : report.moves.kept_in_place);
        --left;
    }
    report.moves.within_tolerance += left;
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
