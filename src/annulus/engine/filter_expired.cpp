// SPDX-License-Identifier: GPL-3.0-or-later
// Which certificates of the vertices that failed have expired.
#include <annulus/engine/filter.h>

#include <algorithm>

namespace annulus {

template <int d>
void Filter<d>::look_at(Certificate_id id, Index v, double reading, List& list, std::span<const Coordinates<d>> x) {
    if (is_of_cell(id)) {
        const Cell_index c = cell_of(id);
        if (!expiries_.has(c) || !table_.is_cell(c)) return;
        const int slot = table_.slot(c, v);
        if (slot < 0) return;
        const Expiry expiry = expiries_.of_cell(table_.corner(c, slot));
        if (expiry.reached(reading)) {
            repair_.suspect_cell(c);
        } else {
            list.put(id, expiry);
        }
        return;
    }
    const Corner_index f = facet_of(id);
    if (!expiries_.has(table_.cell_of(f)) || !table_.is_facet(f)) return;
    const Expiry expiry = expiries_.of_facet(table_, f, v);
    if (expiry == Expiry::never()) return;
    if (!expiry.reached(reading)) {
        list.put(id, expiry);
    } else if (look_ != Second_look::off && second_look(f, x)) {
        const Renewal& renewal = renewals_.back();
        double until = 0.0;
        const Facet_points<d> point = bicell_points(table_, f);
        for (std::size_t k = 0; k < point.size(); ++k)
            if (point[k] == v) until = renewal.expiry[k];
        list.put(id, Expiry::lower(look_ == Second_look::safe_region ? sum_lower(reading, until) : until));
    } else {
        repair_.suspect_facet(f);
    }
}

/// Looks at every certificate of v and fills the list anew. First all records are fetched, so that the loads overlap;
/// then they are sorted out.
template <int d>
void Filter<d>::tour(Index v, double reading, List& list, std::span<const Coordinates<d>> x) {
    ++tours_;
    list.clear();
    certificates_.clear();
    listed_.clear();
    listed_id_.clear();
    for_each_certificate(
        table_, v,
        [&](Corner_index h) {
            expiries_.prefetch(table_.cell_of(h));
            certificates_.push_back(2 * static_cast<std::uint32_t>(h.value()) + 1);
        },
        [&](Corner_index h) { certificates_.push_back(2 * static_cast<std::uint32_t>(h.value())); });
    for (const std::uint32_t k : certificates_) {
        const Corner_index h(static_cast<Index>(k >> 1));
        Certificate_id id = id_of_cell(table_.cell_of(h));
        Expiry expiry;
        if (k & 1) {
            expiry = expiries_.of_cell(h);
        } else {
            const Corner_index f = table_.facet(h);
            id = id_of_facet(f);
            expiry = table_.vertex(h) == v ? expiries_.of_opposite(h) : expiries_.of_facet(table_, f, v);
        }
        if (expiry.reached(reading)) {
            look_at(id, v, reading, list, x);
        } else {
            listed_.push_back(expiry);
            listed_id_.push_back(id);
        }
    }
    list.put_new(listed_, listed_id_);
}

template <int d>
void Filter<d>::begin_anchoring() {
    if (stamp_ == Horizons::stamps) {
        for (auto& list : list_) list.stamp = 0;
        stamp_ = 0;
    }
    ++stamp_;
    anchored_.clear();
    before_.clear();
}

/// Anchors those that failed, where they are now, and suspects their certificates that expired.
template <int d>
void Filter<d>::find_expired(std::span<const Coordinates<d>> x) {
    begin_anchoring();
    for (const Index v : failed_) before_.push_back({vertex_[at(v)], list_[at(v)]});
    for (const Index v : failed_) anchor(v, x);
    for (const Index v : failed_) {
        List& list = list_[at(v)];
        list.take_reached(list.base, [&](Certificate_id id) { look_at(id, v, list.base, list, x); });
        if (list.rest().reached(list.base)) tour(v, list.base, list, x);
    }
}

template <int d>
void Filter<d>::undo_anchoring() {
    for (std::size_t i = 0; i < before_.size(); ++i) {
        vertex_[at(failed_[i])] = before_[i].record;
        list_[at(failed_[i])] = before_[i].list;
    }
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
