// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/relocation_strategy.h>

namespace annulus::inline v1 {

template <int d>
void Relocation_strategy<d>::move(Index v, const Coordinates<d>& p, Move_result& report) {
    const Coordinates<d> source = this->position_[this->at(v)];
    if (source == p) return Rebuild_strategy<d>::move(v, p, report);
    std::vector<Cell_index> discarded;
    auto outcome = &Move_counts::rebuilt;
    try {
        outcome = relocation_.move(this->position_, v, p, discarded);
    } catch (...) {
        this->position_[this->at(v)] = source;
        throw;
    }
    if (outcome == &Move_counts::rebuilt) return Rebuild_strategy<d>::move(v, p, report);
    ++report.moves.asked;
    ++(report.moves.*outcome);
}

template class Relocation_strategy<2>;
template class Relocation_strategy<3>;

}  // namespace annulus::inline v1
