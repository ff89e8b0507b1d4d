// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/relocation.h>

#include <annulus/mesh/table_measures.h>
#include <annulus/published/lawson_flips.h>

#include <utility>

namespace annulus::inline v1 {

template <int d>
auto Relocation<d>::move(std::span<Coordinates<d>> x, Index v, const Coordinates<d>& p,
                         std::vector<Cell_index>& changed) -> Outcome {
    Corner_table<d>& table = mesh_.table();
    Outcome outcome = nullptr;
    if (mesh_.dimension() == d && (in_place_ || flips_)) {
        Coordinates<d>& place = x[static_cast<std::size_t>(v)];
        const Coordinates<d> old = std::exchange(place, p);
        try {
            if (in_place_ && star_holds<d>(table, x, v)) {
                outcome = &Move_counts::kept_in_place;
            } else if constexpr (d == 2) {
                if (flips_ && flip_after_move(table, x, v, signs_, changed))
                    outcome = changed.empty() ? &Move_counts::kept_in_place : &Move_counts::flipped;
            }
        } catch (...) {
            place = old;
            throw;
        }
        if (outcome == nullptr) place = old;
    }
    if (outcome == nullptr) {
        if (!mesh_.reinsert(x, v, p, changed)) return &Move_counts::rebuilt;
        outcome = &Move_counts::reinserted;
    }
    return outcome;
}

template class Relocation<2>;
template class Relocation<3>;

}  // namespace annulus::inline v1
