// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_signs.h>

#include <annulus/mesh/clear_cells.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/orientation_sign.h>
#include <annulus/predicate/perturbed_sign.h>

#include <algorithm>
#include <tuple>
#include <type_traits>

namespace annulus::inline v1 {

namespace {

template <int d>
auto sphere_of(const std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)>& x) {
    using Sphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;
    return std::apply([](const auto&... p) { return Sphere(p...); }, x);
}

}  // namespace

template <int d>
void Periodic_signs<d>::begin(const Periodic_table<d>& table, const Lattice<d>& lattice,
                              std::span<const Coordinates<d>> x, Budget& budget) {
    table_ = &table;
    lattice_ = &lattice;
    x_ = x;
    budget_ = &budget;
    inverted_.clear();
    violated_.clear();
}

template <int d>
int Periodic_signs<d>::sign(const Places& x) {
    Tuple<d, d + 1> corners;
    for (std::size_t i = 0; i <= d; ++i) corners[i] = &x[i];
    budget_->charge(Cost_model<d>::filter);
    if (const int clear = orientation_sign(corners); clear != 0) return clear;
    const Staged_sign s = exact_orientation_sign(corners);
    budget_->charge_later_stage(cost_of<d>(s), doubt_of<d>(s));
    return s.sign;
}

template <int d>
int Periodic_signs<d>::sign(const Cell_images<d>& cell) {
    Places x;
    for (std::size_t i = 0; i <= d; ++i) x[i] = at(cell[i]);
    return sign(x);
}

template <int d>
int Periodic_signs<d>::sign_of_facet(std::size_t c, std::size_t i) {
    const Places x = places(c);
    const Coordinates<d> q = opposite(c, i);
    const auto sphere = sphere_of<d>(x);
    budget_->charge(Cost_model<d>::filter);
    if (sphere.positive()) {
        if (sphere.excludes(q)) return 1;
        if (sphere.contains(q)) return -1;
    } else if (sign(x) <= 0) return 2;
    if (sign(places(Periodic_table<d>::cell_of(table_->twin[c][i]))) <= 0) return 2;
    Tuple<d, d + 2> bicell{};
    for (std::size_t k = 0; k < d; ++k) bicell[k] = &x[k];
    bicell[d] = &q;
    bicell[d + 1] = &x[d];
    const Staged_sign s = exact_empty_sphere_sign(bicell);
    budget_->charge_later_stage(cost_of<d>(s), doubt_of<d>(s));
    if (s.sign != 0) return s.sign;
    return perturbed_sign(bicell) < 0 ? -1 : 0;
}

template <int d>
bool Periodic_signs<d>::is_violated(Corner_index h) {
    return sign_of_facet(Periodic_table<d>::cell_of(h), Periodic_table<d>::slot_of(h)) == -1;
}

/// A facet is clear if it is so from one side; both are tried.
template <int d>
void Periodic_signs<d>::test_cell(std::size_t c, Cospherical* cospherical) {
    const Places x = places(c);
    const auto sphere = sphere_of<d>(x);
    const bool clear = sphere.positive();
    if (!clear && sign(x) <= 0) inverted_.push_back(c);
    for (std::size_t i = 0; i <= d; ++i) {
        if (clear && sphere.excludes(opposite(c, i))) continue;
        const Corner_index t = table_->twin[c][i];
        const std::size_t m = Periodic_table<d>::cell_of(t), j = Periodic_table<d>::slot_of(t);
        if (cospherical != nullptr && (*cospherical)[c][i] != 0) continue;  // seen from the other side
        const int s = sign_of_facet(c, i);
        if (s == -1) violated_.push_back(m < c ? t : Periodic_table<d>::corner(c, i));
        if (s == 0 && cospherical != nullptr) (*cospherical)[c][i] = (*cospherical)[m][j] = 1;
    }
}

template <int d>
void Periodic_signs<d>::test_cell(std::size_t c) {
    budget_->charge(Cost_model<d>::alone);
    test_cell(c, nullptr);
}

template <int d>
double Periodic_signs<d>::expected_cost() const {
    constexpr double more = d == 2 ? 1.6 : 3.3;  // flips find more to repair: of many motions, the mean
    return more * (Cost_model<d>::inverted * static_cast<double>(inverted_.size()) +
                   Cost_model<d>::violated * static_cast<double>(violated_.size()));
}

template <int d>
bool Periodic_signs<d>::test_all_cells() {
    cospherical_.assign(table_->size(), {});
    budget_->charge(static_cast<double>(table_->size()));
    const auto test = [this](std::size_t c) {
        test_cell(c, &cospherical_);
        const double cost = expected_cost();
        return cost == 0 || cost <= budget_->left();
    };
    if (has_fast_clear_cells()) {
        clear_.find(*table_, *lattice_, x_);
        return std::all_of(clear_.rest().begin(), clear_.rest().end(), test);
    }
    for (std::size_t c = 0; c < table_->size(); ++c)
        if (!test(c)) return false;
    return true;
}

template class Periodic_signs<2>;
template class Periodic_signs<3>;

}  // namespace annulus::inline v1
