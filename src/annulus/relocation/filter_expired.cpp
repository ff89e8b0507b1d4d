// SPDX-License-Identifier: GPL-3.0-or-later
// Which certificates of the vertices that failed have expired.
#include <annulus/relocation/filter.h>

#include <algorithm>

namespace annulus {

template <int d>
void Filter<d>::look_at(Index id, Index v, double reading, Expiry_list& list, std::span<const Coordinates<d>> x) {
    if (id & 1) {
        const Index c = id >> 1;
        if (at(c) >= cell_record_.size() || !table_.is_cell(c)) return;
        const int i = table_.slot(c, v);
        if (i < 0) return;
        const Expiry expiry = cell_record_[at(c)].expiry[static_cast<std::size_t>(i)];
        if (reading < expiry.reading()) {
            list.put(id, expiry);
        } else {
            repair_.suspect_cell(c);
        }
        return;
    }
    const Index f = id >> 1;
    const Facet_record& r = facet_record_[at(f)];
    if (!table_.is_facet(f)) return;
    for (std::size_t k = 0; k < r.point.size(); ++k) {
        if (r.point[k] != v) continue;
        if (reading < r.expiry[k].reading()) {
            list.put(id, r.expiry[k]);
        } else if (look_ != Second_look::off && second_look(f, x)) {
            const double renewed = renewals_.back().expiry[k];
            list.put(id, Expiry::lower(look_ == Second_look::safe_region ? sum_lower(reading, renewed) : renewed));
        } else {
            repair_.suspect_facet(f, kind_[at(f)], r.point);
        }
        return;
    }
}

/// The expiry of v in a record, without branches: which point v is cannot be predicted.
template <std::size_t k>
Expiry expiry_of(Index v, const std::array<Index, k>& point, const std::array<Expiry, k>& expiry) {
    Expiry e = Expiry::never();
    for (std::size_t i = 0; i < k; ++i) e = point[i] == v ? expiry[i] : e;
    return e;
}

/// Looks at every certificate of v and fills the list anew. First all expiries are fetched, so that the loads overlap;
/// then they are sorted out.
template <int d>
void Filter<d>::tour(Index v, double reading, Expiry_list& list, std::span<const Coordinates<d>> x) {
    ++tours_;
    list.clear();
    certificates_.clear();
    for_each_certificate(
        table_, v,
        [&](Index h) {
            const Index c = table_.cell_of(h);
            certificates_.push_back(
                {cell_record_[at(c)].expiry[static_cast<std::size_t>(table_.slot_of(h))], id_of_cell(c)});
        },
        [&](Index f) {
            const Facet_record& r = facet_record_[at(f)];
            certificates_.push_back({expiry_of(v, r.point, r.expiry), id_of_facet(f)});
        });
    for (const auto& [expiry, id] : certificates_) {
        if (reading < expiry.reading()) {
            list.put_new(id, expiry);
        } else {
            look_at(id, v, reading, list, x);
        }
    }
}

/// True when nearly every vertex failed and went, by a sample, well beyond the earliest expiry of its certificates: then
/// to evaluate all certificates is cheaper than to ask which expired.
template <int d>
bool Filter<d>::most_expired(std::span<const Coordinates<d>> x) const {
    if (10 * failed_.size() < 7 * x.size() || repair_.kind() == Tolerance_kind::paper) return false;
    const std::size_t stride = 1 + failed_.size() / 256;
    std::size_t sampled = 0;
    std::size_t far = 0;
    for (std::size_t i = 0; i < failed_.size(); i += stride) {
        const Index v = failed_[i];
        ++sampled;
        far += squared_distance<d>(x[at(v)], fixed_position(v)) > 4.0 * vertex_[at(v)].threshold ? 1 : 0;
    }
    return 4 * far > 3 * sampled;
}

/// Whether tolerances would last: by a sample of facets, do two thirds of the certificates survive another step like the one to x?
template <int d>
bool Filter<d>::worth_tracking(std::span<const Coordinates<d>> x, Move_report& report) {
    const Index stride = 1 + table_.facet_bound() / 256;
    repair_.begin(x, false);
    for (Index f = 0; f < table_.facet_bound(); f += stride)
        if (table_.is_facet(f)) repair_.suspect_facet(f);
    (void)repair_.evaluate();
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
    std::size_t sampled = 0;
    std::size_t short_lived = 0;
    for (const auto& s : repair_.facets()) {
        if (s.kind == Facet_kind::border) continue;
        double moved = 0.0;
        for (const Index v : s.point)
            if (v != none) moved = std::max(moved, squared_distance<d>(x[at(v)], position_[at(v)]));
        ++sampled;
        short_lived += moved > s.verdict.tolerance * s.verdict.tolerance ? 1 : 0;
    }
    return 3 * short_lived <= sampled;
}

template <int d>
void Filter<d>::find_expired(std::span<const Coordinates<d>> x) {
    failed_list_.clear();
    for (const Index v : failed_) {
        Expiry_list list = list_[at(v)];
        list.base = reading(v, x[at(v)]);
        while (!list.empty() && !(list.base < list.earliest().reading())) look_at(list.pop(), v, list.base, list, x);
        if (!(list.base < list.rest().reading())) tour(v, list.base, list, x);
        failed_list_.push_back(list);
    }
    prediction_.for_each_due([this](Index id, Time until) {
        const Index i = id >> 1;
        if (id & 1) {
            if (table_.is_cell(i) && cell_until_[at(i)] == until) repair_.suspect_cell(i);
        } else if (table_.is_facet(i) && facet_until_[at(i)] == until) {
            repair_.suspect_facet(i, kind_[at(i)], facet_record_[at(i)].point);
        }
    });
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
