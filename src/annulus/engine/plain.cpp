// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/plain.h>

#include <annulus/arithmetic/error.h>

#include <algorithm>

namespace annulus {

template <int d>
void Plain<d>::begin(std::span<const Coordinates<d>> x, Move_report&) {
    if (x.data() != position_.data()) position_.assign(x.begin(), x.end());
}

template <int d>
void Plain<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    mesh_.rebuild(x);
    report.moves.asked += mesh_.vertices();
    report.moves.rebuilt += mesh_.vertices();
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
}

template <int d>
void Plain<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    if (position_[at(v)] == p) {
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    if (strategy_ == Strategy::rebuild || strategy_ == Strategy::hybrid) {
        std::vector<Coordinates<d>> x = position_;
        x[at(v)] = p;
        mesh_.rebuild(x);
        ++report.moves.rebuilt;
    } else {
        const Coordinates<d> home = position_[at(v)];
        try {
            switch (strategy_ == Strategy::relocate_flips ? mesh_.relocate_in_place(position_, v, p) : mesh_.relocate(position_, v, p)) {
                case Relocation::refused: throw Error(Error_code::collision, "another vertex is at that position");
                case Relocation::kept: ++report.moves.kept_in_place; break;
                case Relocation::reinserted: ++report.moves.reinserted; break;
            }
                } catch (...) {
            position_[at(v)] = home;
            throw;
        }
    }
    ++report.moves.asked;
    position_[at(v)] = p;
}

template <int d>
void Plain<d>::place(Index v, const Coordinates<d>& p) {
    if (at(v) >= position_.size()) position_.resize(at(v) + 1);
    position_[at(v)] = p;
}

template class Plain<2>;
template class Plain<3>;

}  // namespace annulus
