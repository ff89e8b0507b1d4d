// SPDX-License-Identifier: GPL-3.0-or-later
// Paper_strategy: the switch from rebuilding (paper 4.2).
#include <annulus/published/paper_strategy.h>

#include <limits>

namespace annulus::inline v1 {

/// Whether the tolerance of v is greater than its displacement to x, with all other vertices at rest.
template <int d>
bool Paper_strategy<d>::stays(std::span<const Coordinates<d>> x, Index v, Move_result& report) {
    const Corner_table<d>& table = this->mesh().table();
    std::vector<Cell_index> star;
    table.for_each_corner(v, [&](Corner_index h) { star.push_back(table.cell_of(h)); });
    tolerances_.note(star, this->position_, least_, report);
    double own = std::numeric_limits<double>::infinity();
    least_.take([&](Index w, double tolerance) { own = w == v ? tolerance : own; });
    return distance_upper<d>(x[at(v)], this->position_[at(v)]) < own;
}

template <int d>
bool Paper_strategy<d>::sample_stays(std::span<const Coordinates<d>> x, Move_result& report) {
    constexpr int sample = 40;
    constexpr double share = d == 2 ? 0.75 : 0.55;
    const std::size_t bound = this->mesh().vertex_bound();
    least_.resize(bound);
    int within = 0;
    for (int k = 0; k < sample; ++k) {
        Index v = 0;
        do v = static_cast<Index>(random_() % bound);
        while (!this->mesh().has(v));
        within += stays(x, v, report) ? 1 : 0;
    }
    return within >= share * sample;
}

template <int d>
void Paper_strategy<d>::before_step(std::span<const Coordinates<d>> x, Move_result& report) {
    if (has_switched() || switch_.steps++ % 4 != 0) return;
    if (this->mesh().dimension() != d || this->mesh().vertices() < 4 || !sample_stays(x, report)) return;
    recompute_tolerances(this->position_, report);
    this->set_strategy(Strategy::paper);
    switch_.fresh = true;
}

template class Paper_strategy<2>;
template class Paper_strategy<3>;

}  // namespace annulus::inline v1
