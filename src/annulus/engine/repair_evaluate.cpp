// SPDX-License-Identifier: GPL-3.0-or-later
// How suspected certificates get their verdicts: the ladder, in batches and one by one.
#include <annulus/engine/repair.h>

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/certificate/batch.h>
#include <annulus/mesh/border.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/parallel_runs.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <limits>

namespace annulus {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

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

/// The ladder for a run of suspects, stage by stage, so that the rounding mode changes twice. Reads and writes nothing else.
template <int d>
template <class S>
auto Repair<d>::evaluate_run(std::span<S> suspects) const -> Evaluated {
    Evaluated done;
    boost::container::small_vector<std::size_t, 64> open;
    for (std::size_t i = 0; i < suspects.size(); ++i) {
        S& s = suspects[i];
        if (!s.stale || !exists(s)) continue;
        s.stale = false;
        if (s.kind != Facet_kind::border) ++done.certificates;
        if (!filter(s)) {
            open.push_back(i);
        } else if (s.kind != Facet_kind::border) {
            ++done.by.filter;
        }
    }
    if (open.empty()) return done;
    std::size_t left = 0;
    {
        const Rounding_guard guard(FE_UPWARD);  // of this thread
        for (const std::size_t i : open)
            if (!interval(suspects[i])) open[left++] = i;
    }
    done.by.interval = open.size() - left;
    done.by.exact = left;
    for (std::size_t i = 0; i < left; ++i) exact(suspects[open[i]]);
    return done;
}

template <int d>
template <class S>
void Repair<d>::evaluate_stale(std::vector<S>& suspects) {
    constexpr std::size_t run = 1024;  // whatever the number of threads
    const auto add = [this](const Evaluated& here) {
        report_.evaluated += here.certificates;
        report_.arithmetic += here.by;
    };
    if (suspects.size() <= run) return add(evaluate_run(std::span(suspects)));
    std::vector<Evaluated> done((suspects.size() + run - 1) / run);
    for_each_run(suspects.size(), run, threads_, [&](std::size_t first, std::size_t last) {
        done[first / run] = evaluate_run(std::span(suspects).subspan(first, last - first));
    });
    for (const Evaluated& here : done) add(here);
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
    return !border_in_doubt() || border_winds_once(embedding_.table(), x_);
}

template <int d>
bool Repair<d>::border_in_doubt() const {
    return many_ && (signs_ || (d == 2 && !cells_.empty()) ||
                     std::any_of(facets_.begin(), facets_.end(), [](const auto& s) { return s.kind == Facet_kind::ridge; }));
}

/// In batches: ridges with the cells, both being orientations.
template <int d>
bool Repair<d>::star_holds(Index v, Least_tolerance& least) {
    if (many_ || kind_ == Tolerance_kind::paper) return false;
    const auto& t = embedding_.table();
    star_.clear();
    const auto add_orientation = [&](const Cell_points<d>& x) {
        star_.simplex.push_back(x);
        star_.orientation.push_back(tuple<d, d + 1>(x, x_));
    };
    for_each_certificate(
        t, v,
        [&](Corner_index h) {
            const Cell_points<d> x = cell_points(t, t.cell_of(h));
            if (std::find(x.begin(), x.end(), infinite) == x.end()) add_orientation(x);
        },
        [&](Corner_index h) {
            const Facet_kind kind = facet_kind(t, h);
            if (kind == Facet_kind::empty_sphere) {
                star_.bicell.push_back(bicell_points(t, h));
                star_.empty_sphere.push_back(tuple<d, d + 2>(star_.bicell.back(), x_));
            } else if (kind == Facet_kind::ridge) {
                add_orientation(ridge_vertex_last(t, h, ridge_points(t, h)));
            }
        });
    const Mode mode = certified() ? Mode::fast : Mode::floating;
    const auto all_hold = [&](const auto& tuples, const auto& points, Stage_counts& counts) {
        verdict_.resize(tuples.size());
        counts += annulus::evaluate(std::span(tuples), mode, verdict_);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (verdict_[i].sign <= 0) return false;
            least.note(points[i], verdict_[i].tolerance);
        }
        return true;
    };
    Stage_counts counts;
    if (!all_hold(star_.orientation, star_.simplex, counts) || !all_hold(star_.empty_sphere, star_.bicell, counts)) {
        least.clear();
        return false;
    }
    report_.evaluated += counts.total();
    report_.arithmetic += counts;
    return true;
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
