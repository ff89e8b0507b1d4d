// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_tolerances: a step.
#include <annulus/engine/periodic_tolerances.h>

#include <annulus/arithmetic/limits.h>
#include <annulus/engine/displacement.h>
#include <annulus/mesh/sort_unique.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

template <int d>
bool Periodic_tolerances<d>::begin_step(Periodic_motion<d>& motion, const Lattice<d>& lattice, std::size_t most) {
    step_.failed.clear();
    if (!kept_) return false;
    kept_ = false;
    if (motion.relabels_home() || !box_.follow(lattice)) return false;
    step_.star_walks = 0;
    find_failed(motion, !motion.changes_box());
    return step_.failed.size() <= most;
}

/// What fails: points that are not surely near enough to their anchors. What is at rest is as it was, also without any
/// tolerance, if the box is.
template <int d>
void Periodic_tolerances<d>::find_failed(Periodic_motion<d>& motion, bool same_box) {
    const auto home = motion.home();
    const auto goal = motion.goal();
    const double gone = gone_upper();
    for (std::size_t v = 0; v < goal.size(); ++v) {
        const Record& r = of_.vertex[v];
        const Coordinates<d> z = box_.comoving(goal[v]);
        double squares = 0;
        for (std::size_t k = 0; k < d; ++k) squares += (z[k] - r.anchor[k]) * (z[k] - r.anchor[k]);
        // As squared_threshold_lower does; the difference is off by u of it, which its square is twice.
        const double left = r.until - gone;
        if (left > 0x1p-450 && squares < left * left * (1 - 0x1p-48)) [[likely]]
            continue;
        if ((same_box && home[v] == goal[v]) || !is_place<d>(goal[v])) continue;
        step_.failed.push_back(static_cast<Index>(v));
    }
}

template <int d>
void Periodic_tolerances<d>::begin_anchoring() {
    if (of_.stamp == Limits::stamps) {
        for (auto& list : of_.list) list.stamp = 0;
        of_.stamp = 0;
    }
    ++of_.stamp;
    step_.anchored.clear();
}

template <int d>
void Periodic_tolerances<d>::anchor(Index v, const Coordinates<d>& place) {
    auto& list = of_.list[at(v)];
    if (list.stamp == of_.stamp) return;
    list.stamp = of_.stamp;
    step_.anchored.push_back(v);
    Record& r = of_.vertex[at(v)];
    const Coordinates<d> z = box_.anchor(place);
    if (z == r.anchor) return;
    list.base = sum_upper(list.base, distance_upper<d>(z, r.anchor));
    r.anchor = z;
}

/// For v; of a vertex that is several of its points all expiries are the same. Never where it is none of them.
template <int d>
Expiry Periodic_tolerances<d>::expiry_of(const Periodic_table<d>& table, Certificate_id id, Index v) const {
    const auto images = certificate_images<d>(table, id);
    const bool cell = is_of_cell(id);
    for (std::size_t k = 0; k < images.size(); ++k) {
        if (images[k].vertex != v) continue;
        if (cell) return of_.expiries.of_cell(table.corner(cell_of(id).offset(), k));
        const Corner_index f = facet_of(id);
        return of_.expiries.of_facet(f, table.twin[table.cell_of(f)][table.slot_of(f)], k);
    }
    return Expiry::never();
}

/// An entry of a list, which may be of what is there no more: it has expired, or it is listed again.
template <int d>
void Periodic_tolerances<d>::check(const Periodic_table<d>& table, Certificate_id id, Index v) {
    if (!has_certificate<d>(table, id)) return;
    const Expiry expiry = expiry_of(table, id, v);
    if (expiry == Expiry::never()) return;
    auto& list = of_.list[at(v)];
    if (expiry.reached(sum_upper(list.base, gone_upper()))) step_.ids.push_back(id);
    else list.put(id, expiry);
}

/// Lists all certificates of v again, but for those that have expired.
template <int d>
void Periodic_tolerances<d>::walk(const Periodic_table<d>& table, Periodic_star<d>& star, Index v) {
    ++step_.star_walks;
    of_.list[at(v)].clear();
    for (const Corner_index h : star.of(table, v)) {
        const std::size_t c = table.cell_of(h), own = table.slot_of(h);
        check(table, periodic_cell_id(c), v);
        for (std::size_t i = 0; i <= d; ++i)  // a facet that v is a corner of is seen from two cells at it
            if (i == own || table.corner(c, i) < table.twin[c][i]) check(table, facet_id<d>(table, c, i), v);
    }
}

template <int d>
Stage_counts Periodic_tolerances<d>::find_expired(const Periodic_view<d>& at_goals, Periodic_star<d>& star) {
    begin_anchoring();
    step_.ids.clear();
    for (const Index v : step_.failed) anchor(v, at_goals.place[at(v)]);
    for (const Index v : step_.failed) {
        auto& list = of_.list[at(v)];
        const double reading = sum_upper(list.base, gone_upper());
        if (list.rest().reached(reading)) walk(at_goals.table, star, v);
        else list.take_reached(reading, [&](Certificate_id id) { check(at_goals.table, id, v); });
    }
    sort_unique(step_.ids);
    step_.evaluated.resize(step_.ids.size());
    return evaluate_periodic<d>(at_goals, step_.ids, threads_, step_.evaluated);
}

template <int d>
void Periodic_tolerances<d>::relabel(const Periodic_motion<d>& motion) {
    for (const Index v : motion.wrapped()) {
        Record& r = of_.vertex[at(v)];
        r.anchor = box_.relabelled(r.anchor, motion.growth_at_goal(v));
    }
}

template <int d>
Stage_counts Periodic_tolerances<d>::evaluate_again(const Periodic_view<d>& view,
                                                    std::span<const std::size_t> changed) {
    const auto& table = view.table;
    std::vector<Certificate_id> ids;
    for (const Certificate_id id : step_.ids) {
        if (is_of_cell(id) ? has_certificate<d>(table, id) : table.cell_of(facet_of(id)) < table.size())
            ids.push_back(
                is_of_cell(id) ? id : facet_id<d>(table, table.cell_of(facet_of(id)), table.slot_of(facet_of(id))));
    }
    for (const std::size_t c : changed)
        for_each_certificate_of_cell<d>(table, c, [&](Certificate_id id) { ids.push_back(id); });
    sort_unique(ids);
    step_.ids = std::move(ids);
    step_.evaluated.resize(step_.ids.size());
    return evaluate_periodic<d>(view, step_.ids, threads_, step_.evaluated);
}

/// Writes the expiries of a certificate whose points are anchored where it was evaluated: first into the lists, which
/// are hints, then where the truth is.
template <int d>
void Periodic_tolerances<d>::write(const Periodic_table<d>& table, const Evaluated& e) {
    const bool cell = is_of_cell(e.id);
    double tolerance = e.tolerance / Reference_box<d>::path_factor;
    // Orientations do not depend on the deformation of the box.
    if (!cell && e.radius > 0) tolerance = std::min(tolerance, e.tolerance * (reach_ / e.radius));
    tolerance = std::max(0.0, tolerance * (1 - 0x1p-48) - box_.error_upper());
    tolerance = tolerance * (1 - 0x1p-50);
    const Corner_index f = cell ? no_corner : facet_of(e.id);
    for (std::size_t k = 0; k < e.vertex.size(); ++k) {
        const Index v = e.vertex[k];
        if (v == none) continue;
        auto& list = of_.list[at(v)];
        const Expiry expiry = Expiry::lower(sum_lower(sum_lower(list.base, gone_lower()), tolerance));
        list.put(e.id, expiry);
        if (cell) of_.expiries.of_cell(table.corner(cell_of(e.id).offset(), k)) = expiry;
        else of_.expiries.of_facet(f, table.twin[table.cell_of(f)][table.slot_of(f)], k) = expiry;
    }
}

template <int d>
void Periodic_tolerances<d>::set_until(Index v) {
    const double left = of_.list[at(v)].earliest().path_length() - of_.list[at(v)].base;
    of_.vertex[at(v)].until = left - std::fabs(left) * 0x1p-50;
}

template <int d>
void Periodic_tolerances<d>::commit(const Periodic_view<d>& view) {
    resize(view);
    for (const Evaluated& e : step_.evaluated)
        for (const Index v : e.vertex)
            if (v != none) anchor(v, view.place[at(v)]);
    for (const Evaluated& e : step_.evaluated) write(view.table, e);
    double longest = 0;
    for (const Index v : step_.anchored) {
        set_until(v);
        longest = std::max(longest, of_.list[at(v)].base);
    }
    kept_ = longest + gone_upper() <= Limits::path_ratio * reach_;
}

template class Periodic_tolerances<2>;
template class Periodic_tolerances<3>;

}  // namespace annulus::inline v1
