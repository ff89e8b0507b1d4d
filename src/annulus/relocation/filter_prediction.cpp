// SPDX-License-Identifier: GPL-3.0-or-later
// When `filter` predicts a motion, and when it stops.
#include <annulus/relocation/filter.h>

#include <algorithm>

namespace annulus {

namespace {
constexpr std::size_t settling_price = 3;  // in failures a vertex: 310 and 190 ns when measured, and the terms to come
}  // namespace

/// When as much was spent on failures as a settling with a prediction would cost, the
/// displacements of two consecutive steps are compared (rent or buy). A prediction promises to be worth it when a step
/// resembles the one before and neighbours move alike.
template <int d>
void Filter<d>::note_displacements(std::span<const Coordinates<d>> x) {
    this_step_.clear();
    if (spent_ < settling_price * x.size()) return;
    this_step_.resize(x.size());
    for (std::size_t v = 0; v < x.size(); ++v)
        if (table_.corner_of(static_cast<Index>(v)) != none)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
                this_step_[v][k] = x[v][k] - position_[v][k];
}

/// With a prediction a certificate of tolerance s lasts about s / 2 rho steps, without s / max |u|. True when, over a
/// sample of facets, the first is at least three times as long.
template <int d>
bool Filter<d>::coherent(const std::vector<Coordinates<d>>& velocity) const {
    const Index bound = table_.facet_bound();
    const Index stride = 1 + bound / 1024;
    double relative = 0.0;
    double absolute = 0.0;
    for (Index f = 0; f < bound; f += stride) {
        if (!table_.is_facet(f) || kind_[at(f)] != Facet_kind::empty_sphere) continue;
        const auto& point = facet_record_[at(f)].point;
        double fastest = 0.0;
        for (const Index v : point) fastest = std::max(fastest, squared_distance<d>(velocity[at(v)], Coordinates<d>{}));
        absolute += std::sqrt(fastest);
        relative += Prediction<d>::spread(point, [&](Index v) -> const Coordinates<d>& { return velocity[at(v)]; });
    }
    return 2.0 * relative < absolute;
}

template <int d>
void Filter<d>::reconsider(Move_report& report) {
    if (this_step_.empty() || spent_ < settling_price * this_step_.size()) {  // also when a rebuild has settled meanwhile
        last_step_.clear();
        return;
    }
    if (last_step_.size() != this_step_.size()) {
        std::swap(last_step_, this_step_);
        return;
    }
    double way = 0.0;
    double change = 0.0;
    for (std::size_t v = 0; v < this_step_.size(); ++v) {
        way += squared_distance<d>(this_step_[v], Coordinates<d>{});
        change += squared_distance<d>(this_step_[v], last_step_[v]);
    }
    last_step_.clear();
    spent_ = 0;
    // Deviations a quarter of displacements, in the mean.
    if (change < 0.0625 * way && coherent(this_step_)) {
        prediction_.adopt(this_step_, vertex_, reach());
        settle_here(report);
    } else if (prediction_.active()) {
        settle(position_, report);
    }
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
