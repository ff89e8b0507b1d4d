// SPDX-License-Identifier: GPL-3.0-or-later
// Which certificates of the vertices that failed have expired.
#include <annulus/engine/filter.h>

#include <algorithm>

namespace annulus {

/// The expiry of v in a record, without branches: which point v is cannot be predicted. Never when it is none of them.
template <std::size_t k>
Expiry expiry_of(Index v, const std::array<Index, k>& point, const std::array<Expiry, k>& expiry) {
    Expiry e = Expiry::never();
    for (std::size_t i = 0; i < k; ++i) e = point[i] == v ? expiry[i] : e;
    return e;
}

template <int d>
void Filter<d>::look_at(Index id, Index v, double reading, List& list, std::span<const Coordinates<d>> x) {
    const Index i = id >> 1;
    if (id & 1) {
        if (at(i) >= cell_record_.size() || !table_.is_cell(i)) return;
        const int slot = table_.slot(i, v);
        if (slot < 0) return;
        const Expiry expiry = cell_record_[at(i)].expiry[static_cast<std::size_t>(slot)];
        if (expiry.reached(reading)) {
            repair_.suspect_cell(i);
        } else {
            list.put(id, expiry);
        }
        return;
    }
    const Facet_record& r = facet_record_[at(i)];
    const Expiry expiry = expiry_of(v, r.point, r.expiry);
    if (expiry == Expiry::never() || !table_.is_facet(i)) return;
    if (!expiry.reached(reading)) {
        list.put(id, expiry);
    } else if (look_ != Second_look::off && second_look(i, x)) {
        const Renewal& renewal = renewals_.back();
        double until = 0.0;
        for (std::size_t k = 0; k < r.point.size(); ++k)
            if (r.point[k] == v) until = renewal.expiry[k];
        list.put(id, Expiry::lower(look_ == Second_look::safe_region ? sum_lower(reading, until) : until));
    } else {
        repair_.suspect_facet(i, kind_[at(i)], r.point);
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
        [&](Index h) {
            const Cell_record& r = cell_record_[at(table_.cell_of(h))];
            __builtin_prefetch(&r);
            certificates_.push_back(2 * static_cast<std::uint32_t>(h) + 1);
        },
        [&](Index h) {
            const Index f = table_.facet(h);
            const Facet_record& r = facet_record_[at(f)];
            __builtin_prefetch(&r);
            __builtin_prefetch(&r.point.back());
            certificates_.push_back(2 * static_cast<std::uint32_t>(f));
        });
    for (const std::uint32_t k : certificates_) {
        const Index i = static_cast<Index>(k >> 1);
        Index id = id_of_facet(i);
        Expiry expiry;
        if (k & 1) {
            id = id_of_cell(table_.cell_of(i));
            expiry = cell_record_[at(table_.cell_of(i))].expiry[static_cast<std::size_t>(table_.slot_of(i))];
        } else {
            expiry = expiry_of(v, facet_record_[at(i)].point, facet_record_[at(i)].expiry);
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
        list.take_reached(list.base, [&](Index id) { look_at(id, v, list.base, list, x); });
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
