// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/relocation_strategy.h>

#include <annulus/arithmetic/error.h>

namespace annulus {

template <int d>
void Relocation_strategy<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    std::vector<Coordinates<d>>& x = this->position_;
    const Coordinates<d> source = x[this->at(v)];
    if (source == p) {
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    try {
        const bool in_place = this->strategy() == Strategy::relocate_flips;
        switch (in_place ? this->mesh().relocate_in_place(x, v, p) : this->mesh().relocate(x, v, p)) {
            case Relocation::refused: throw Error(Error_code::duplicate_point, "another vertex is at that position");
            case Relocation::kept: ++report.moves.kept_in_place; break;
            case Relocation::reinserted: ++report.moves.reinserted; break;
        }
    } catch (...) {
        x[this->at(v)] = source;
        throw;
    }
    ++report.moves.asked;
    x[this->at(v)] = p;
}

template class Relocation_strategy<2>;
template class Relocation_strategy<3>;

}  // namespace annulus
