// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/rebuild_strategy.h>

#include <algorithm>

namespace annulus::inline v1 {

template <int d>
void Rebuild_strategy<d>::begin(std::span<const Coordinates<d>> x, Move_result&) {
    if (x.data() != position_.data()) position_.assign(x.begin(), x.end());
}

template <int d>
void Rebuild_strategy<d>::move_all(std::span<const Coordinates<d>> x, Move_result& report) {
    mesh_.rebuild(x);
    report.moves.asked += mesh_.vertices();
    report.moves.rebuilt += mesh_.vertices();
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
}

template <int d>
void Rebuild_strategy<d>::move(Index v, const Coordinates<d>& p, Move_result& report) {
    if (position_[at(v)] != p) {
        std::vector<Coordinates<d>> x = position_;
        x[at(v)] = p;
        mesh_.rebuild(x);
        ++report.moves.rebuilt;
    } else {
        ++report.moves.within_tolerance;
    }
    ++report.moves.asked;
    position_[at(v)] = p;
}

template <int d>
void Rebuild_strategy<d>::add_vertex(Index v, const Coordinates<d>& p) {
    if (at(v) >= position_.size()) position_.resize(at(v) + 1);
    position_[at(v)] = p;
}

template class Rebuild_strategy<2>;
template class Rebuild_strategy<3>;

}  // namespace annulus::inline v1
