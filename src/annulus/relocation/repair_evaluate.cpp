// SPDX-License-Identifier: GPL-3.0-or-later
// How suspected certificates get their verdicts: the ladder, in batches and one by one.
#include <annulus/relocation/repair.h>

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/certificate/circumcircle_2.h>
#include <annulus/certificate/circumsphere_3.h>
#include <annulus/triangulation/degenerate.h>

#include <algorithm>
#include <limits>

namespace annulus {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
std::size_t at(Index i) { return static_cast<std::size_t>(i); }

template <int d, std::size_t k, std::size_t n>
Tuple<d, static_cast<int>(k)> tuple(const std::array<Index, n>& point,
                                    std::span<const Coordinates<d>> x) requires(k <= n) {
    Tuple<d, static_cast<int>(k)> t{};
    for (std::size_t i = 0; i < k; ++i) t[i] = &x[at(point[i])];
    return t;
}

}  // namespace

template <int d>
bool Repair<d>::filter(Facet_suspect& s) const {
    if (s.kind == Facet_kind::empty_sphere) {
        if (!empty_sphere_filter(tuple<d, d + 2>(s.point, x_), certified(), s.verdict)) return false;
        if constexpr (d == 3)  // in the plane it is the only annulus
            if (kind_ == Tolerance_kind::paper && s.verdict.sign > 0)
                s.verdict.tolerance = paper_annulus(tuple<d, d + 2>(s.point, x_));
        return true;
    }
    if (s.kind != Facet_kind::border) {
        const auto x = tuple<d, d + 1>(s.point, x_);
        if (!orientation_filter(x, certified(), s.verdict)) return false;
        if (kind_ == Tolerance_kind::paper && s.verdict.sign > 0)
            s.verdict.tolerance = s.kind == Facet_kind::ridge ? paper_ridge(x) : paper_slab(x);
        return true;
    }
    s.verdict = {no_limit, 1, Stage::filter};
    return true;
}

template <int d>
bool Repair<d>::filter(Cell_suspect& s) const {
    if (s.kind != Facet_kind::border) return orientation_filter(tuple<d, d + 1>(s.point, x_), certified(), s.verdict);
    s.verdict = {no_limit, 1, Stage::filter};
    return true;
}

template <int d>
bool Repair<d>::interval(Facet_suspect& s) const {
    return s.kind == Facet_kind::empty_sphere ? empty_sphere_interval(tuple<d, d + 2>(s.point, x_), s.verdict)
                                              : orientation_interval(tuple<d, d + 1>(s.point, x_), s.verdict);
}

template <int d>
bool Repair<d>::interval(Cell_suspect& s) const {
    return orientation_interval(tuple<d, d + 1>(s.point, x_), s.verdict);
}

template <int d>
void Repair<d>::exact(Facet_suspect& s) const {
    s.verdict = s.kind == Facet_kind::empty_sphere ? empty_sphere_exact(tuple<d, d + 2>(s.point, x_))
                                                   : orientation_exact(tuple<d, d + 1>(s.point, x_));
}

template <int d>
void Repair<d>::exact(Cell_suspect& s) const {
    s.verdict = orientation_exact(tuple<d, d + 1>(s.point, x_));
}

template <int d>
template <class S>
void Repair<d>::evaluate_stale(std::vector<S>& suspects) {
    unresolved_.clear();
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        S& s = suspects[i];
        if (!s.stale || !exists(s)) continue;
        s.stale = false;
        if (s.kind != Facet_kind::border) ++report_.evaluated;
        if (!filter(s)) {
            unresolved_.push_back(static_cast<Index>(i));
        } else if (s.kind != Facet_kind::border) {
            ++report_.arithmetic.filter;
        }
    }
    if (unresolved_.empty()) return;
    std::size_t open = 0;
    {
        const Rounding_guard guard(FE_UPWARD);  // one for the batch
        for (const Index i : unresolved_)
            if (!interval(suspects[at(i)])) unresolved_[open++] = i;
    }
    report_.arithmetic.interval += unresolved_.size() - open;
    report_.arithmetic.exact += open;
    for (std::size_t i = 0; i < open; ++i) exact(suspects[at(unresolved_[i])]);
}

template <int d>
template <class S>
void Repair<d>::decide(S& s) {
    if (!s.stale) return;
    s.stale = false;
    ++report_.evaluated;
    if (filter(s)) {
        ++report_.arithmetic.filter;
        return;
    }
    bool answered = false;
    {
        const Rounding_guard guard(FE_UPWARD);
        answered = interval(s);
    }
    if (!answered) exact(s);
    report_.arithmetic.count(answered ? Stage::interval : Stage::exact);
}

template <int d>
const typename Repair<d>::Facet_suspect& Repair<d>::examine_facet(Index f) {
    if (at(f) >= place_of_facet_.size() || place_of_facet_[at(f)] == 0) suspect_facet(f);
    Facet_suspect& s = facets_[at(place_of_facet_[at(f)] - 1)];
    decide(s);
    return s;
}

template <int d>
const typename Repair<d>::Cell_suspect& Repair<d>::examine_cell(Index c) {
    if (at(c) >= place_of_cell_.size() || place_of_cell_[at(c)] == 0) suspect_cell(c);
    Cell_suspect& s = cells_[at(place_of_cell_[at(c)] - 1)];
    decide(s);
    return s;
}

template <int d>
bool Repair<d>::violated(const Facet_suspect& s) const {
    if (s.kind == Facet_kind::border) return false;
    if (s.kind == Facet_kind::slab) return s.verdict.sign <= 0;
    if (s.kind == Facet_kind::ridge) {
        if (s.verdict.sign != 0) return s.verdict.sign < 0;
        return !flat_ridge_holds(tuple<d, d + 1>(s.point, x_));
    }
    if (s.verdict.sign != 0) return s.verdict.sign < 0;
    return perturbed_sign(tuple<d, d + 2>(s.point, x_)) < 0;
}

template <int d>
bool Repair<d>::evaluate() {
    evaluate_stale(facets_);
    evaluate_stale(cells_);
    // The perturbation needs positive cells; where a cell is inverted the answer is no anyway.
    const auto fails = [this](const auto& s) { return this->exists(s) && this->violated(s); };
    if (std::any_of(cells_.begin(), cells_.end(), fails) || std::any_of(facets_.begin(), facets_.end(), fails))
        return false;
    if (!many_) return true;
    const bool in_doubt =
        everything_ || (d == 2 && !cells_.empty()) ||
        std::any_of(facets_.begin(), facets_.end(), [](const auto& s) { return s.kind == Facet_kind::ridge; });
    return !in_doubt || border_winds_once();
}

/// Signs alone, triangle by triangle. Every edge is asked from both sides, because which side is to ask would be a branch
/// that no processor predicts, dearer than the answer.
template <>
bool Repair<2>::evaluate_everything() {
    const auto& t = embedding_.table();
    everything_ = true;
    std::uint64_t held = 0;
    for (Index c = 0; c < t.cell_bound(); ++c) {
        if (!t.is_cell(c)) continue;
        const std::array<Index, 3> v = cell_points(t, c);
        if (v[0] < 0 || v[1] < 0 || v[2] < 0) {
            for (int i = 0; i < 3; ++i) {
                const Index h = t.corner(c, i);
                if (h < t.twin(h) && t.is_infinite(t.cell_of(t.twin(h)))) suspect_facet(t.facet(h));  // a ridge
            }
            continue;
        }
        const Circumcircle_2 circle(x_[at(v[0])], x_[at(v[1])], x_[at(v[2])]);
        const bool positive = circle.positive();
        const auto opposite = [&](int i) { return t.vertex(t.twin(t.corner(c, i))); };
        // At infinity a corner stands in, of which nothing can be said.
        const auto excludes = [&](int i) { return circle.excludes(x_[at(opposite(i) < 0 ? v[0] : opposite(i))]); };
        const std::array<bool, 3> outside{excludes(0), excludes(1), excludes(2)};
        if (positive + outside[0] + outside[1] + outside[2] == 4) [[likely]] {
            held += 5;  // a cell and half of three facets, twice
            continue;
        }
        held += positive ? 2 : 0;
        if (!positive) suspect_cell(c);
        for (int i = 0; i < 3; ++i) {
            if (opposite(i) == infinite) continue;
            if (positive && outside[static_cast<std::size_t>(i)]) {
                ++held;
            } else {
                suspect_facet(t.facet(t.corner(c, i)));
            }
        }
    }
    report_.evaluated += held / 2;
    report_.arithmetic.filter += held / 2;
    return evaluate();
}

/// The same of space, tetrahedron by tetrahedron.
template <>
bool Repair<3>::evaluate_everything() {
    const auto& t = embedding_.table();
    everything_ = true;
    std::uint64_t held = 0;
    for (Index c = 0; c < t.cell_bound(); ++c) {
        if (!t.is_cell(c)) continue;
        const Cell_points<3> v = cell_points(t, c);
        if (v[0] < 0 || v[1] < 0 || v[2] < 0 || v[3] < 0) {
            for (int i = 0; i <= 3; ++i) {
                const Index h = t.corner(c, i);
                if (v[static_cast<std::size_t>(i)] != infinite && h < t.twin(h)) suspect_facet(t.facet(h));  // a ridge
            }
            continue;
        }
        const Circumsphere_3 sphere(x_[at(v[0])], x_[at(v[1])], x_[at(v[2])], x_[at(v[3])]);
        const bool positive = sphere.positive();
        const auto opposite = [&](int i) { return t.vertex(t.twin(t.corner(c, i))); };
        const auto excludes = [&](int i) { return sphere.excludes(x_[at(opposite(i) < 0 ? v[0] : opposite(i))]); };
        const std::array<bool, 4> outside{excludes(0), excludes(1), excludes(2), excludes(3)};
        if (positive + outside[0] + outside[1] + outside[2] + outside[3] == 5) [[likely]] {
            held += 6;  // a cell and half of four facets, twice
            continue;
        }
        held += positive ? 2 : 0;
        if (!positive) suspect_cell(c);
        for (int i = 0; i <= 3; ++i) {
            if (opposite(i) == infinite) continue;
            if (positive && outside[static_cast<std::size_t>(i)]) {
                ++held;
            } else {
                suspect_facet(t.facet(t.corner(c, i)));
            }
        }
    }
    report_.evaluated += held / 2;
    report_.arithmetic.filter += held / 2;
    return evaluate();
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
