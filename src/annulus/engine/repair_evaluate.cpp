// SPDX-License-Identifier: GPL-3.0-or-later
// How suspected certificates get their verdicts: the ladder, in batches.
#include <annulus/engine/repair.h>

#include <annulus/certificate/batch.h>
#include <annulus/mesh/border.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/parallel_runs.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace annulus {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Suspects whose certificates go through the ladder together, each with the positions of its points. On the stack, since threads
/// evaluate side by side; few, since a single move asks for few.
template <class S, class T>
struct Batch {
    static constexpr std::size_t capacity = 64;
    std::array<T, capacity> tuple;
    std::array<S*, capacity> suspect;
    std::size_t size = 0;
};

}  // namespace

/// What the kind `paper` has in place of a tolerance, where the filter stage found that the certificate holds.
template <int d>
double Repair<d>::paper_tolerance(const Facet_suspect& s) const {
    if (s.kind == Facet_kind::empty_sphere) {
        if constexpr (d == 3) return paper_annulus(tuple<d, d + 2>(s.point, x_));
        else return s.verdict.tolerance;  // in the plane it is the only annulus
    }
    const auto x = tuple<d, d + 1>(s.point, x_);
    return s.kind == Facet_kind::ridge ? paper_ridge(x) : paper_slab(x);
}

/// The ladder for a run of suspects, in batches. Reads and writes nothing else.
template <int d>
template <class S>
Stage_counts Repair<d>::evaluate_run(std::span<S> suspects) const {
    constexpr bool of_facets = std::is_same_v<S, Facet_suspect>;
    Stage_counts counts;
    const auto evaluate = [&]<class T>(Batch<S, T>& batch) {
        if (batch.size == 0) return;
        boost::container::static_vector<Verdict, Batch<S, T>::capacity> verdict(batch.size);  // an array would be filled whole
        counts += annulus::evaluate(std::span<const T>(batch.tuple.data(), batch.size), mode(), {verdict.data(), batch.size});
        for (std::size_t i = 0; i < batch.size; ++i) {
            S& s = *batch.suspect[i];
            s.verdict = verdict[i];
            s.stale = false;
            if constexpr (of_facets)
                if (kind_ == Tolerance_kind::paper && s.verdict.stage == Stage::filter && s.verdict.sign > 0)
                    s.verdict.tolerance = paper_tolerance(s);
        }
        batch.size = 0;
    };
    const auto add = [&]<class T>(S& s, const T& x, Batch<S, T>& batch) {
        batch.tuple[batch.size] = x;
        batch.suspect[batch.size] = &s;
        if (++batch.size == batch.capacity) evaluate(batch);
    };
    Batch<S, Tuple<d, d + 1>> orientations;
    Batch<S, Tuple<d, d + 2>> empty_spheres;
    for (S& s : suspects) {
        if (!s.stale || !exists(s)) continue;
        if (s.kind == Facet_kind::nothing) {
            s.verdict = {no_limit, 1, Stage::filter};
            s.stale = false;
            continue;
        }
        if constexpr (of_facets) {
            if (s.kind == Facet_kind::empty_sphere) {
                add(s, tuple<d, d + 2>(s.point, x_), empty_spheres);
                continue;
            }
        }
        add(s, tuple<d, d + 1>(s.point, x_), orientations);
    }
    evaluate(orientations);
    evaluate(empty_spheres);
    return counts;
}

template <int d>
template <class S>
void Repair<d>::evaluate_stale(std::span<S> suspects) {
    if (suspects.empty()) return;  // as cells often are
    constexpr std::size_t run = 1024;  // whatever the number of threads
    const auto add = [this](const Stage_counts& counts) {
        report_.evaluated += counts.total();
        report_.arithmetic += counts;
    };
    if (suspects.size() <= run) return add(evaluate_run(suspects));
    std::vector<Stage_counts> counts((suspects.size() + run - 1) / run);
    for_each_run(suspects.size(), run, threads_, [&](std::size_t first, std::size_t last) {
        counts[first / run] = evaluate_run(suspects.subspan(first, last - first));
    });
    for (const Stage_counts& here : counts) add(here);
}

template <int d>
bool Repair<d>::violated(const Facet_suspect& s) const {
    if (s.kind == Facet_kind::nothing) return false;
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
    evaluate_stale(std::span(facets_));
    evaluate_stale(std::span(cells_));
    // The perturbation needs positive cells; where a cell is inverted the answer is no anyway.
    const auto fails = [this](const auto& s) { return this->exists(s) && this->violated(s); };
    if (std::any_of(cells_.begin(), cells_.end(), fails) || std::any_of(facets_.begin(), facets_.end(), fails))
        return false;
    return border_holds();
}

template <int d>
bool Repair<d>::border_in_doubt() const {
    return many_ && (signs_ || (d == 2 && !cells_.empty()) ||
                     std::any_of(facets_.begin(), facets_.end(), [](const auto& s) { return s.kind == Facet_kind::ridge; }));
}

template <int d>
bool Repair<d>::border_holds() {
    if (!border_in_doubt()) return true;
    std::size_t seen = 0;
    const bool holds = border_winds_once(mesh_.table(), x_, seen);
    aside_ += Prices<d>::border * static_cast<double>(seen);
    return holds;
}

/// In batches: ridges with the cells, both being orientations.
template <int d>
bool Repair<d>::star_holds(Index v, Least_tolerance& least) {
    if (many_ || kind_ == Tolerance_kind::paper) return false;
    const auto& t = mesh_.table();
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
    const auto all_hold = [&](const auto& tuples, const auto& points, Stage_counts& counts) {
        verdict_.resize(tuples.size());
        counts += annulus::evaluate(std::span(tuples), mode(), verdict_);
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
// For repair.cpp.
template void Repair<2>::evaluate_stale(std::span<Facet_suspect>);
template void Repair<2>::evaluate_stale(std::span<Cell_suspect>);
template void Repair<3>::evaluate_stale(std::span<Facet_suspect>);
template void Repair<3>::evaluate_stale(std::span<Cell_suspect>);

}  // namespace annulus
