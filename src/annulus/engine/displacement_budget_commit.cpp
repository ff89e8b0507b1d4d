// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement_budget: what is written down of evaluated certificates.
#include <annulus/engine/displacement_budget.h>

#include <annulus/engine/trace.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {
constexpr Expiry never = Expiry::never();
constexpr std::size_t prefetched = 8;  // certificates ahead
}  // namespace

/// Writes the expiries of a certificate evaluated at the step's positions, here and in the lists of its points.
template <int d>
template <bool fresh, class S, class Expiry_of>
void Displacement_budget<d>::commit_points(const S& s, Certificate_id id, Expiry_of expiry_of, Step<d>* step) {
    for (std::size_t k = 0; k < s.point.size(); ++k) {
        const Index v = s.point[k].vertex;
        if (v == none) continue;
        if constexpr (!fresh) anchor(v, *step);
        List& list = list_[at(v)];
        const Expiry expiry = Expiry::lower(sum_lower(list.base, s.value.tolerance));
        expiry_of(k) = expiry;
        if constexpr (fresh) {
            list.put_new(id, expiry);
        } else {
            list.put(id, expiry);
        }
    }
    ANNULUS_TRACED(written(*this, s, id, expiry_of));
}

/// Fetches what commit_points() needs first of these points: whether they are anchored. A branch on it would have to
/// wait.
template <int d>
template <class Points>
void Displacement_budget<d>::prefetch(const Points& points) const {
    for (const auto& [v, label] : points)
        if (v != none) {
            __builtin_prefetch(&list_[at(v)], 1);
            __builtin_prefetch(&vertex_[at(v)], 1);
        }
}

template <int d>
template <bool fresh>
void Displacement_budget<d>::commit_evaluated(const Certificate_checker<d>& checker, Step<d>* step) {
    const auto facets = checker.facets();
    if (!fresh)
        for (std::size_t i = 0; i < std::min(prefetched, facets.size()); ++i) prefetch(facets[i].point);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        if (!fresh && i + prefetched < facets.size()) prefetch(facets[i + prefetched].point);
        const auto& s = facets[i];
        if (!checker.exists(s)) continue;
        const Corner_index twin = table_.twin(s.id);
        const auto expiry_of = [&](std::size_t k) -> Expiry& { return expiries_.of_facet(s.id, twin, k); };
        if (s.kind == Facet_kind::empty_sphere) {
            commit_points<fresh>(s, id_of_facet(s.id), expiry_of, step);
            continue;
        }
        for (std::size_t k = 0; k < s.point.size(); ++k) expiry_of(k) = never;
        if (s.kind == Facet_kind::nothing) continue;
        const Facet_sites<d> around = bicell_sites(table_, s.id);
        const auto place_of = [&](std::size_t k) {
            return static_cast<std::size_t>(std::find(around.begin(), around.end(), s.point[k]) - around.begin());
        };
        commit_points<fresh>(
            s, id_of_facet(s.id), [&](std::size_t k) -> Expiry& { return expiry_of(place_of(k)); }, step);
    }
    for (const auto& s : checker.cells()) {
        if (!checker.exists(s)) continue;
        const auto expiry_of = [&](std::size_t k) -> Expiry& {
            return expiries_.of_cell(Corner_table<d>::corner(s.id, static_cast<int>(k)));
        };
        if (s.kind != Facet_kind::nothing) commit_points<fresh>(s, id_of_cell(s.id), expiry_of, step);
        else
            for (std::size_t k = 0; k < s.point.size(); ++k) expiry_of(k) = never;
    }
}

/// Sets `base` of v to 0 and lowers the expiries of its certificates accordingly, so that what is left of each stays
/// the same. A large `base` would round tolerances away.
template <int d>
void Displacement_budget<d>::rebase(Index v) {
    List& list = list_[at(v)];
    const double base = list.base;
    list.clear();
    list.base = 0.0;
    const auto shift = [&](Expiry& e, Certificate_id id) {
        if (e == never) return;
        const double left = e.path_length() - base;
        e = Expiry::lower(left - left * 0x1p-52);
        list.put(id, e);
    };
    for_each_certificate(
        table_, v, [&](Corner_index h) { shift(expiries_.of_cell(h), id_of_cell(table_.cell_of(h))); },
        [&](Corner_index h) {
            const Corner_index f = table_.facet(h);
            const Facet_sites<d> point = bicell_sites(table_, f);
            for (std::size_t k = 0; k < point.size(); ++k)
                if (point[k].vertex == v) shift(expiries_.of_facet(f, table_.twin(f), k), id_of_facet(f));
        });
    ANNULUS_TRACED(rebased(*this, v));
}

template <int d>
void Displacement_budget<d>::commit(Step<d>& step, const Certificate_checker<d>& checker) {
    resize();
    ANNULUS_TRACED(committing(*this, checker));
    commit_evaluated<false>(checker, &step);
    for (const Index v : step.anchored) {
        const List& list = list_[at(v)];
        if (list.base > Limits::path_ratio * (list.latest().path_length() - list.base)) rebase(v);
        set_threshold(v);
        ANNULUS_TRACED(finished(*this, v));
    }
    ANNULUS_TRACED(committed(*this));
}

template <int d>
void Displacement_budget<d>::commit_fresh(const Certificate_checker<d>& checker) {
    commit_evaluated<true>(checker, nullptr);
}

template class Displacement_budget<2>;
template class Displacement_budget<3>;

}  // namespace annulus::inline v1
