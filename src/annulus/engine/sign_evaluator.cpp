// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/sign_evaluator.h>

#include <annulus/engine/cost_model.h>
#include <annulus/mesh/clear_cells.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/mesh/sort_unique.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/orientation_sign.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace annulus::inline v1 {

namespace {

template <int d>
using Circumsphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;

}  // namespace

template <int d>
void Sign_evaluator<d>::begin(std::span<const Coordinates<d>> x, Budget& budget) {
    x_ = x;
    budget_ = &budget;
    middle_.reset();
    found_.inverted.clear();
    found_.violated.clear();
    found_.clear_halves = found_.cells = 0;
    decided_ = {};
}

/// Some of the points are enough: the middle only has to be inside.
template <int d>
void Sign_evaluator<d>::find_middle() {
    Coordinates<d>& middle = middle_.emplace();
    const Index stride = 1 + table_.vertex_bound() / 64;
    double points = 0.0;
    for (Index v = 0; v < table_.vertex_bound(); v += stride) {
        if (table_.corner_of(v) == no_corner) continue;
        for (std::size_t k = 0; k < middle.size(); ++k) middle[k] += x_[at(v)][k];
        points += 1.0;
    }
    for (double& c : middle) c /= std::max(points, 1.0);
}

template <int d>
int Sign_evaluator<d>::decided(Staged_sign s) {
    decided_.count(s.stage);
    budget_->charge_later_stage(cost_of<d>(s), doubt_of<d>(s));
    return s.sign;
}

template <int d>
int Sign_evaluator<d>::sign(const Cell_sites<d>& x) {
    bool at_infinity = false;
    for (const Site<d> s : x) at_infinity |= s.vertex == infinite;
    if (at_infinity && !middle_) find_middle();
    Tuple<d, d + 1> p{};
    for (std::size_t k = 0; k < x.size(); ++k) p[k] = position(x[k].vertex);
    int sign = orientation_sign(p);
    if (!clearly(sign)) sign = decided(exact_orientation_sign(p));
    return at_infinity ? -sign : sign;
}

/// Counts a sign that the filter stage decided; false if it did not.
template <int d>
bool Sign_evaluator<d>::clearly(int sign) {
    if (sign == 0) return false;
    ++decided_.filter;
    budget_->charge(Cost_model<d>::filter);
    return true;
}

/// The sign of the bi-cell at half-facet h, by the filter stage: 0 when the next stage has to decide.
template <int d>
[[gnu::flatten]] int Sign_evaluator<d>::sphere_sign(Corner_index h) {
    const Cell_sites<d> v = cell_sites(table_, table_.cell_of(h));
    const Coordinates<d>& p = x_[at(table_.opposite(h).vertex)];
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        const Circumsphere<d> sphere(x_[at(v[i].vertex)]...);
        if (!sphere.positive()) return 0;
        return sphere.excludes(p) ? 1 : sphere.contains(p) ? -1 : 0;
    }
    (std::make_index_sequence<d + 1>());
}

template <int d>
bool Sign_evaluator<d>::is_violated(Corner_index f) {
    const Facet_kind kind = facet_kind(table_, f);
    if (kind == Facet_kind::nothing) return false;
    if (kind == Facet_kind::ridge) {
        const auto x = tuple<d, d + 1>(facet_certificate(table_, f, false).point, x_);
        const int clear = orientation_sign(x);
        if (clearly(clear)) return clear < 0;
        const int s = decided(exact_orientation_sign(x));
        return s != 0 ? s < 0 : !flat_ridge_holds(x);
    }
    const int clear = sphere_sign(f);
    if (clearly(clear)) return clear < 0;
    const auto x = tuple<d, d + 2>(bicell_sites(table_, f), x_);
    const int s = decided(exact_empty_sphere_sign(x));
    if (s != 0) return s < 0;
    if (is_inverted(table_.cell_of(f)) || is_inverted(table_.cell_of(table_.twin(f)))) return false;  // they come first
    return perturbed_sign(x) < 0;
}

/// If both cells of a facet are tested, it is tested from both sides: choosing one side would be a branch that no
/// processor predicts, more expensive than the test. Flattened, because a call between two halves of a formula would
/// spill every register.
template <int d>
[[gnu::flatten]] void Sign_evaluator<d>::test_cell(Cell_index c, bool border, Found& found) const {
    const auto& t = table_;
    const Cell_sites<d> v = cell_sites(t, c);
    ++found.cells;
    if (std::any_of(v.begin(), v.end(), [](Site<d> w) { return w.vertex < 0; })) {
        if (border) found.inverted.push_back(c);
        for (int i = 0; i <= d; ++i) {
            const Corner_index h = t.corner(c, i);
            if (t.vertex(h) != infinite) found.violated.push_back(t.facet(h));  // a ridge
        }
        return;
    }
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        const Circumsphere<d> sphere(x_[at(v[i].vertex)]...);
        const Cell_sites<d> opposite{t.opposite(t.corner(c, static_cast<int>(i)))...};
        // A corner of the cell stands in for infinity; nothing can be said of it.
        const auto beyond = [&](std::size_t k) -> const Coordinates<d>& {
            return x_[at(opposite[k].vertex == infinite ? v[0].vertex : opposite[k].vertex)];
        };
        if (sphere.excludes_all(beyond(i)...)) [[likely]] {
            found.clear_halves += d + 3;
            return;
        }
        const bool positive = sphere.positive();
        const std::array<bool, d + 1> outside{sphere.excludes(beyond(i))...};
        if (positive) found.clear_halves += 2;
        else found.inverted.push_back(c);
        for (std::size_t k = 0; k <= d; ++k) {
            if (opposite[k].vertex == infinite) continue;
            if (positive && outside[k]) ++found.clear_halves;
            else found.violated.push_back(t.facet(t.corner(c, static_cast<int>(k))));
        }
    }
    (std::make_index_sequence<d + 1>());
}

/// Adds what was found in a run of cells, in the order of the runs.
template <int d>
void Sign_evaluator<d>::take(const Found& found) {
    found_.inverted.insert(found_.inverted.end(), found.inverted.begin(), found.inverted.end());
    found_.violated.insert(found_.violated.end(), found.violated.begin(), found.violated.end());
    found_.clear_halves += found.clear_halves;
    budget_->charge(static_cast<double>(found.cells));
}

template <int d>
void Sign_evaluator<d>::test_all_cells() {
    constexpr std::size_t run = 1U << 14;  // the same for every number of threads
    const std::size_t cells = table_.cell_bound().offset();
    std::vector<Found> found((cells + run - 1) / run);
    for_each_run(cells, run, threads_, [&](std::size_t first, std::size_t last) {
        Found& here = found[first / run];
        if (has_fast_clear_cells()) {
            std::vector<Cell_index> rest;
            const std::size_t clear = clear_cells<d>(table_, x_, Cell_index(static_cast<Index>(first)),
                                                     Cell_index(static_cast<Index>(last)), rest);
            here.cells += clear;
            here.clear_halves += (d + 3) * clear;
            for (const Cell_index c : rest) test_cell(c, false, here);
            return;
        }
        // The positions of a cell's neighbours are three dependent loads away, so they are prefetched for some cells
        // ahead.
        constexpr Index ahead = 16;
        const Index end = static_cast<Index>(last);
        for (Index begin = static_cast<Index>(first); begin < end; begin += ahead) {
            const Index next = std::min(begin + ahead, end);
            for (Cell_index c(begin); c.value() < next; ++c)
                for (int i = 0; i <= d; ++i)
                    if (const Corner_index t = table_.twin(table_.corner(c, i)); t != no_corner)
                        __builtin_prefetch(&x_[at(std::max(table_.vertex(t), Index{0}))]);
            for (Cell_index c(begin); c.value() < next; ++c)
                if (table_.is_cell(c)) test_cell(c, false, here);
        }
    });
    for (const Found& here : found) take(here);
    // A facet that does not hold is mostly found from both sides. Sorting out duplicates by comparison would be the
    // greatest cost of a step that is given up.
    sort_unique(found_.violated, table_.facet_bound());
}

template <int d>
void Sign_evaluator<d>::test_star(Index v, bool border) {
    table_.for_each_corner(v, [&](Corner_index h) { test_cell(Corner_table<d>::cell_of(h), border); });
}

template <int d>
Repair_estimate Sign_evaluator<d>::estimate() {
    constexpr std::size_t sampled = 64;
    const auto failing = [](const auto& list, auto fails) {
        const std::size_t stride = 1 + list.size() / sampled;
        std::size_t asked = 0, failed = 0;
        for (std::size_t k = 0; k < list.size(); k += stride, ++asked) failed += fails(list[k]) ? 1U : 0U;
        return asked == 0 ? 0.0
                          : static_cast<double>(list.size()) * static_cast<double>(failed) / static_cast<double>(asked);
    };
    const auto inverted = [this](Cell_index c) {
        budget_->charge(Cost_model<d>::filter);
        return !table_.is_infinite(c) && orientation_sign(tuple<d, d + 1>(cell_sites(table_, c), x_)) < 0;
    };
    const auto crossed = [this](Corner_index f) {
        budget_->charge(Cost_model<d>::filter);
        return facet_kind(table_, f) == Facet_kind::empty_sphere && sphere_sign(f) < 0;
    };
    return {Cost_model<d>::inverted * failing(found_.inverted, inverted),
            Cost_model<d>::violated * failing(found_.violated, crossed)};
}

template class Sign_evaluator<2>;
template class Sign_evaluator<3>;

}  // namespace annulus::inline v1
