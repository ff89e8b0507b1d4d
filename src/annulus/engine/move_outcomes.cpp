// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/move_outcomes.h>

#include <algorithm>

namespace annulus::inline v1 {

template <int d>
void Move_outcomes<d>::count(const Step<d>& step, std::size_t asked, Move_counts& moves) {
    const auto mark = [this](Index v) -> std::uint32_t& { return mark_[static_cast<std::size_t>(v)]; };
    moves.asked += asked;
    if (step.rebuilt) {
        moves.rebuilt += asked;
        return;
    }
    if (stamp_ >= Limits::stamps - 3) {  // the sum would wrap before it is compared
        std::fill(mark_.begin(), mark_.end(), 0);
        stamp_ = 0;
    }
    stamp_ += 2;  // its mark, and the one above it
    std::size_t left = asked;
    for (const Index v : step.reinserted) {
        if ((step.mover != none && v != step.mover) || mark(v) == stamp_) continue;
        mark(v) = stamp_;
        ++moves.reinserted;
        --left;
    }
    // Marks the affected vertices that are not reinserted; those of them that failed were flipped.
    for (const Index v : step.affected)
        if (mark(v) != stamp_) mark(v) = stamp_ + 1;
    for (const Index v : step.failed) {
        if (mark(v) == stamp_) continue;
        ++(mark(v) == stamp_ + 1 ? moves.flipped : moves.kept_in_place);
        --left;
    }
    moves.within_tolerance += left;
}

template class Move_outcomes<2>;
template class Move_outcomes<3>;

}  // namespace annulus::inline v1
