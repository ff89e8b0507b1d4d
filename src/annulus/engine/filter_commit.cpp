// SPDX-License-Identifier: GPL-3.0-or-later
// What `filter` writes down of certificates that were evaluated, and how it starts.
#include <annulus/engine/filter.h>

#include <algorithm>

namespace annulus {

namespace {
constexpr Expiry never = Expiry::never();
constexpr std::size_t prefetched = 8;  // certificates ahead
}  // namespace

template <int d>
void Filter<d>::resize() {
    const std::size_t n = at(table_.vertex_bound());
    grow(position_, n);
    grow(disturbed_stamp_, n);
    if (!tracks_) return;
    grow(vertex_, n);
    grow(list_, n);
    expiries_.resize(table_.cell_bound());
    if (look_ != Second_look::off) grow(tolerance_, table_.facet_bound());
}

template <int d>
void Filter<d>::settle(std::span<const Coordinates<d>> x, Move_report& report) {
    const bool own = x.data() == position_.data();
    if (!embedding_.mirrored()) embedding_.mirror();
    tracks_ = true;
    try {
        resize();
        if (own) x = position_;
        take_up(x, report);
    } catch (...) {
        tracks_ = false;
        throw;
    }
    if (!own) std::copy(x.begin(), x.end(), position_.begin());
}

/// Fresh tolerances of everything at x.
template <int d>
void Filter<d>::take_up(std::span<const Coordinates<d>> x, Move_report& report) {
    failures_ = evaluated_ = 0;
    overdraft_ = 0.0;
    settles_next_ = false;
    ++report.settlings;
    for (std::size_t v = 0; v < x.size(); ++v) vertex_[v] = {x[v], {}};
    std::fill(list_.begin(), list_.end(), List{});
    if (embedding_.dimension() == d) evaluate_all(x, report);
}

template <int d>
void Filter<d>::begin(std::span<const Coordinates<d>> x, Move_report& report) {
    if (!automatic_) return settle(x, report);
    if (x.data() != position_.data()) position_.assign(x.begin(), x.end());
    stop_tracking();
    embedding_.drop_mirror();
}

/// In blocks that stay in the cache from the evaluation to what is written down; several threads want larger ones. The order is the same.
template <int d>
void Filter<d>::evaluate_all(std::span<const Coordinates<d>> x, Move_report& report) {
    const auto in_blocks = [&]<class I>(I bound, auto suspect) {
        const Index block = threads_ > 1 ? 1 << 16 : 1024;
        for (Index first = 0; first < bound.value(); first += block) {
            repair_.begin(x, false);
            const Index last = std::min(bound.value(), first + block);
            for (I i(first); i.value() < last; ++i) suspect(i);
            (void)repair_.evaluate();
            commit_evaluated<true>(x);
            report.evaluated += repair_.report().evaluated;
            report.arithmetic += repair_.report().arithmetic;
        }
    };
    in_blocks(table_.facet_bound(), [this](Corner_index f) {
        if (table_.is_facet(f)) repair_.suspect_facet(f);
    });
    in_blocks(table_.cell_bound(), [this](Cell_index c) {
        if (table_.is_cell(c)) repair_.suspect_cell(c);
    });
    for (Index v = 0; v < table_.vertex_bound(); ++v) set_threshold(v);
}

/// Tolerances are given up: no vertex that moves passes until the next settling.
template <int d>
void Filter<d>::stop_tracking() {
    tracks_ = false;
    release(vertex_);
    release(list_);
    expiries_.free();
    release(tolerance_);
    release(delimiter_);
    settles_next_ = false;
    untracked_ = 0;
    single_moves_ = 0;
}

template <int d>
void Filter<d>::place(Index v, const Coordinates<d>& p) {
    if (at(v) >= position_.size()) position_.resize(at(v) + 1);
    position_[at(v)] = p;
    if (!embedding_.mirrored()) return;
    resize();
    if (!tracks_) return;
    vertex_[at(v)] = {p, {}};
    list_[at(v)].clear();
}

template <int d>
void Filter<d>::refresh(std::span<const Cell_index> cells, Move_report& report) {
    renewals_.clear();
    failed_.clear();
    if (!embedding_.mirrored()) return;
    resize();
    if (!tracks_) return;
    begin_anchoring();
    repair_.begin(position_);
    repair_.suspect_cells(cells);
    (void)repair_.evaluate();
    commit(position_);
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
}

template <int d>
void Filter<d>::anchor(Index v, std::span<const Coordinates<d>> x) {
    List& list = list_[at(v)];
    if (list.stamp == stamp_) return;
    list.stamp = stamp_;
    anchored_.push_back(v);
    Vertex_record<d>& r = vertex_[at(v)];
    if (x[at(v)] == r.fixed) return;
    list.base = reading(v, x[at(v)]);
    r.fixed = x[at(v)];
}

/// Gives a certificate evaluated at x its expiries and tells its points.
template <int d>
template <bool fresh, class S, class Expiry_of>
void Filter<d>::commit_points(const S& s, Certificate_id id, Expiry_of expiry_of, std::span<const Coordinates<d>> x) {
    for (std::size_t k = 0; k < s.point.size(); ++k) {
        if (s.point[k] == none) continue;
        if constexpr (!fresh) anchor(s.point[k], x);
        List& list = list_[at(s.point[k])];
        const Expiry expiry = Expiry::lower(sum_lower(list.base, s.verdict.tolerance));
        expiry_of(k) = expiry;
        if constexpr (fresh) {
            list.put_new(id, expiry);
        } else {
            list.put(id, expiry);
        }
    }
}

template <int d>
void Filter<d>::commit_renewals(std::span<const Coordinates<d>> x) {
    for (const Renewal& renewal : renewals_) {
        if (!table_.is_facet(renewal.facet)) continue;
        const Corner_index twin = table_.twin(renewal.facet);
        const Facet_points<d> point = bicell_points(table_, renewal.facet);
        if (std::find(point.begin(), point.end(), infinite) != point.end()) continue;  // it is another by now
        if (look_ == Second_look::unequal_moves) tolerance_[renewal.facet] = 0.0;
        for (std::size_t k = 0; k < point.size(); ++k) {
            const Index v = point[k];
            double expiry = renewal.expiry[k];
            if (look_ == Second_look::safe_region) {  // the room is around the present position
                anchor(v, x);
                expiry = sum_lower(list_[at(v)].base, expiry);
            }
            expiries_.of_facet(renewal.facet, twin, k) = Expiry::lower(expiry);
            list_[at(v)].put(id_of_facet(renewal.facet), Expiry::lower(expiry));
            if (list_[at(v)].stamp != stamp_) set_threshold(v);
        }
    }
}

/// What commit_points() needs of these points first: whether they are anchored. A guess would have to wait for it.
template <int d>
template <class Points>
void Filter<d>::prefetch(const Points& points) const {
    for (const Index v : points)
        if (v != none) __builtin_prefetch(&list_[at(v)], 1);
}

template <int d>
template <bool fresh>
void Filter<d>::commit_evaluated(std::span<const Coordinates<d>> x) {
    const auto facets = repair_.facets();
    for (std::size_t i = 0; i < facets.size(); ++i) {
        if (!fresh && i + prefetched < facets.size()) prefetch(facets[i + prefetched].point);
        const auto& s = facets[i];
        if (!repair_.exists(s)) continue;
        const Corner_index twin = table_.twin(s.id);
        if (look_ != Second_look::off) tolerance_[s.id] = s.verdict.tolerance;
        if constexpr (d == 2)
            if (look_ == Second_look::safe_region && s.kind == Facet_kind::empty_sphere)
                keep_delimiter(s.id, s.point, x);
        const auto expiry_of = [&](std::size_t k) -> Expiry& { return expiries_.of_facet(s.id, twin, k); };
        if (s.kind == Facet_kind::empty_sphere) {
            commit_points<fresh>(s, id_of_facet(s.id), expiry_of, x);
            continue;
        }
        for (std::size_t k = 0; k < s.point.size(); ++k) expiry_of(k) = never;
        if (s.kind == Facet_kind::border) continue;
        const Facet_points<d> around = bicell_points(table_, s.id);
        const auto place_of = [&](std::size_t k) {
            return static_cast<std::size_t>(std::find(around.begin(), around.end(), s.point[k]) - around.begin());
        };
        commit_points<fresh>(s, id_of_facet(s.id), [&](std::size_t k) -> Expiry& { return expiry_of(place_of(k)); }, x);
    }
    for (const auto& s : repair_.cells()) {
        if (!repair_.exists(s)) continue;
        const auto expiry_of = [&](std::size_t k) -> Expiry& {
            return expiries_.of_cell(Cell_table<d>::corner(s.id, static_cast<int>(k)));
        };
        if (s.kind != Facet_kind::border && repair_.kind() != Tolerance_kind::paper)
            commit_points<fresh>(s, id_of_cell(s.id), expiry_of, x);
        else
            for (std::size_t k = 0; k < s.point.size(); ++k) expiry_of(k) = never;
    }
}

/// Starts v's odometer at 0 again: what is left of each of its certificates stays what it is. Odometers that have come
/// a long way would round tolerances away.
template <int d>
void Filter<d>::rebase(Index v) {
    List& list = list_[at(v)];
    const double base = list.base;
    list.clear();
    list.base = 0.0;
    const auto shift = [&](Expiry& e, Certificate_id id) {
        if (e == never) return;
        const double left = e.reading() - base;
        e = Expiry::lower(left - left * 0x1p-52);
        list.put(id, e);
    };
    for_each_certificate(
        table_, v,
        [&](Corner_index h) {
            shift(expiries_.of_cell(h), id_of_cell(table_.cell_of(h)));
        },
        [&](Corner_index h) {
            const Corner_index f = table_.facet(h);
            const Facet_points<d> point = bicell_points(table_, f);
            for (std::size_t k = 0; k < point.size(); ++k) {
                if (point[k] != v) continue;
                Expiry& e = expiries_.of_facet(f, table_.twin(f), k);
                // Unequal moves infer the reference from the expiry, which they cannot once it has been cut off at 0.
                if (look_ != Second_look::off && e.reading() < base) tolerance_[f] = 0.0;
                shift(e, id_of_facet(f));
            }
        });
}

template <int d>
void Filter<d>::commit(std::span<const Coordinates<d>> x) {
    resize();
    commit_renewals(x);
    commit_evaluated<false>(x);
    for (const Index v : anchored_) {
        const List& list = list_[at(v)];
        if (list.base > Horizons::odometer * (list.latest().reading() - list.base)) rebase(v);
        set_threshold(v);
    }
    failed_.clear();
    renewals_.clear();
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
