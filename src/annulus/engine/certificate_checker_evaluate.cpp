// SPDX-License-Identifier: GPL-3.0-or-later
// How pending certificates get their values: by filtered predicates, in batches.
#include <annulus/engine/certificate_checker.h>

#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/predicate/batch.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>

namespace annulus::inline v1 {

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Entries whose certificates are evaluated together, with the positions of their points. On the stack, because
/// threads evaluate at the same time; small, because a single move needs few.
template <class S, class T>
struct Batch {
    static constexpr std::size_t capacity = 64;
    std::array<T, capacity> tuple;
    std::array<S*, capacity> entry;
    std::size_t size = 0;
};

}  // namespace

/// Evaluates the filtered predicates of every `stride`th entry of a run, in batches. Reads and writes nothing else.
template <int d>
template <class S>
Stage_counts Certificate_checker<d>::evaluate_run(std::span<S> entries, std::size_t stride) const {
    constexpr bool of_facets = std::is_same_v<S, Pending_facet>;
    Stage_counts counts;
    const auto evaluate = [&]<class T>(Batch<S, T>& batch) {
        if (batch.size == 0) return;
        boost::container::static_vector<Certificate_value, Batch<S, T>::capacity> value(
            batch.size);  // an array would be filled as a whole
        counts += annulus::evaluate(std::span<const T>(batch.tuple.data(), batch.size),
                                    Tolerance_precision::lower_bound, {value.data(), batch.size});
        for (std::size_t i = 0; i < batch.size; ++i) {
            S& s = *batch.entry[i];
            s.value = value[i];
            s.stale = false;
        }
        batch.size = 0;
    };
    const auto add = [&]<class T>(S& s, const T& x, Batch<S, T>& batch) {
        batch.tuple[batch.size] = x;
        batch.entry[batch.size] = &s;
        if (++batch.size == batch.capacity) evaluate(batch);
    };
    Batch<S, Tuple<d, d + 1>> orientations;
    Batch<S, Tuple<d, d + 2>> empty_spheres;
    for (std::size_t i = 0; i < entries.size(); i += stride) {
        S& s = entries[i];
        if (!s.stale || !exists(s)) continue;
        if (s.kind == Facet_kind::nothing) {
            s.value = {no_limit, 1, Stage::filter};
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
Stage_counts Certificate_checker<d>::evaluate_stale(std::span<S> entries) const {
    if (entries.empty()) return {};    // often there are no cells to evaluate
    constexpr std::size_t run = 1024;  // the same for every number of threads
    if (entries.size() <= run) return evaluate_run(entries);
    std::vector<Stage_counts> counts((entries.size() + run - 1) / run);
    for_each_run(entries.size(), run, threads_, [&](std::size_t first, std::size_t last) {
        counts[first / run] = evaluate_run(entries.subspan(first, last - first));
    });
    Stage_counts all;
    for (const Stage_counts& here : counts) all += here;
    return all;
}

template <int d>
Stage_counts Certificate_checker<d>::evaluate_from(std::size_t facet, std::size_t cell) {
    Stage_counts counts = evaluate_stale(std::span(facets_).subspan(facet));
    counts += evaluate_stale(std::span(cells_).subspan(cell));
    return counts;
}

template <int d>
Stage_counts Certificate_checker<d>::evaluate_some(std::size_t stride) {
    Stage_counts counts = evaluate_run(std::span(facets_), stride);
    counts += evaluate_run(std::span(cells_), stride);
    return counts;
}

template <int d>
bool Certificate_checker<d>::is_violated(const Pending_facet& s) const {
    if (s.kind == Facet_kind::nothing) return false;
    if (s.kind == Facet_kind::ridge) {
        if (s.value.sign != 0) return s.value.sign < 0;
        return !flat_ridge_holds(tuple<d, d + 1>(s.point, x_));
    }
    if (s.value.sign != 0) return s.value.sign < 0;
    return perturbed_sign(tuple<d, d + 2>(s.point, x_)) < 0;
}

template <int d>
bool Certificate_checker<d>::all_hold() const {
    const auto fails = [this](const auto& s) { return this->exists(s) && this->is_violated(s); };
    return std::none_of(cells_.begin(), cells_.end(), fails) && std::none_of(facets_.begin(), facets_.end(), fails);
}

template class Certificate_checker<2>;
template class Certificate_checker<3>;

}  // namespace annulus::inline v1
