// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement_budget: which certificates of the vertices that failed have expired.
#include <annulus/engine/displacement_budget.h>

#include <annulus/engine/trace.h>

#include <algorithm>

namespace annulus::inline v1 {

/// Tests one certificate of v, which is anchored: it has expired and becomes pending, or it returns to the list.
template <int d>
void Displacement_budget<d>::check_expiry(Certificate_id id, Index v, Certificate_checker<d>& checker) {
    List& list = list_[at(v)];
    if (is_of_cell(id)) {
        const Cell_index c = cell_of(id);
        if (!expiries_.has(c) || !table_.is_cell(c)) return;
        const int slot = table_.slot(c, Site<d>(v));
        if (slot < 0) return;
        const Expiry expiry = expiries_.of_cell(table_.corner(c, slot));
        if (expiry.reached(list.base)) {
            checker.add_cell(c);
            ANNULUS_TRACED(made_pending(id));
        } else {
            list.put(id, expiry);
        }
        return;
    }
    const Corner_index f = facet_of(id);
    if (!expiries_.has(table_.cell_of(f)) || !table_.is_facet(f)) return;
    const Expiry expiry = expiries_.of_facet(table_, f, v);
    if (expiry == Expiry::never()) return;
    if (!expiry.reached(list.base)) {
        list.put(id, expiry);
    } else {
        checker.add_facet(f);
        ANNULUS_TRACED(made_pending(id));
    }
}

/// The star walk: tests every certificate of v and refills its list. First it fetches all records, so that the loads
/// overlap; then it sorts them.
template <int d>
void Displacement_budget<d>::visit_star(Index v, Step<d>& step, Certificate_checker<d>& checker) {
    List& list = list_[at(v)];
    ++step.star_walks;
    list.clear();
    walk_.certificates.clear();
    walk_.listed.clear();
    walk_.listed_id.clear();
    for_each_certificate(
        table_, v,
        [&](Corner_index h) {
            expiries_.prefetch(table_.cell_of(h));
            walk_.certificates.push_back(2 * static_cast<std::uint32_t>(h.value()) + 1);
        },
        [&](Corner_index h) { walk_.certificates.push_back(2 * static_cast<std::uint32_t>(h.value())); });
    Corner_index own;  // the corner of v in the cell of the facets that follow
    for (const std::uint32_t k : walk_.certificates) {
        const Corner_index h(static_cast<Index>(k >> 1));
        Certificate_id id = id_of_cell(table_.cell_of(h));
        Expiry expiry;
        if (k & 1) {
            own = h;
            expiry = expiries_.of_cell(h);
        } else {
            id = id_of_facet(table_.facet(h));
            expiry = expiries_.of_facet(table_, h, own);
        }
        if (expiry.reached(list.base)) {
            check_expiry(id, v, checker);
        } else {
            walk_.listed.push_back(expiry);
            walk_.listed_id.push_back(id);
        }
    }
    list.put_new(walk_.listed, walk_.listed_id);
    ANNULUS_TRACED(walked(*this, v));
}

template <int d>
void Displacement_budget<d>::begin_anchoring(Step<d>& step) {
    if (stamp_ == Limits::stamps) {
        for (auto& list : list_) list.stamp = 0;
        stamp_ = 0;
    }
    ++stamp_;
    step.anchored.clear();
    step.before.clear();
    ANNULUS_TRACED(anchoring(*this, step));
}

template <int d>
void Displacement_budget<d>::anchor(Index v, Step<d>& step) {
    List& list = list_[at(v)];
    if (list.stamp == stamp_) return;
    list.stamp = stamp_;
    step.anchored.push_back(v);
    Vertex_record<d>& r = vertex_[at(v)];
    if (step.x[at(v)] == r.fixed) return;
    list.base = path_length(v, step.x[at(v)]);
    r.fixed = step.x[at(v)];
}

template <int d>
void Displacement_budget<d>::find_expired(Step<d>& step, Certificate_checker<d>& checker) {
    begin_anchoring(step);
    for (const Index v : step.failed) step.before.push_back({vertex_[at(v)], list_[at(v)]});
    for (const Index v : step.failed) anchor(v, step);
    ANNULUS_TRACED(anchored(*this, step));
    for (const Index v : step.failed) {
        List& list = list_[at(v)];
        if (!list.rest().reached(list.base))  // else visit_star() tests these as well
            list.take_reached(list.base, [&](Certificate_id id) { check_expiry(id, v, checker); });
        if (list.rest().reached(list.base)) visit_star(v, step, checker);
        ANNULUS_TRACED(examined(*this, v));
    }
}

template <int d>
void Displacement_budget<d>::undo(const Step<d>& step) {
    for (std::size_t i = 0; i < step.before.size(); ++i) {
        vertex_[at(step.failed[i])] = step.before[i].record;
        list_[at(step.failed[i])] = step.before[i].list;
    }
    ANNULUS_TRACED(undone(*this, step));
}

template class Displacement_budget<2>;
template class Displacement_budget<3>;

}  // namespace annulus::inline v1
