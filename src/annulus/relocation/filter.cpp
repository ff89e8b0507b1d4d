// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/relocation/filter.h>

#include <algorithm>

namespace annulus {

namespace {
constexpr double never = std::numeric_limits<double>::infinity();
}  // namespace

template <int d>
void Filter<d>::list_changes(Move_report& report) const {
    if (!report_changes_) return;
    const auto& t = embedding_.table();
    for (const Index c : repair_.changed_cells())
        if (t.is_cell(c))
            for (int i = 0; i <= d; ++i) report.changed.push_back(t.vertex(t.corner(c, i)));
}

template <int d>
void Filter<d>::resize() {
    const std::size_t n = at(table_.vertex_bound());
    position_.resize(n);
    fixed_.resize(n);
    threshold_.resize(n, 0.0);
    list_.resize(n);
    prediction_.resize(n);
    stamp_.resize(n, 0);
    disturbed_stamp_.resize(n, 0);
    Facet_record no_facet{};
    no_facet.expiry.fill(never);
    no_facet.until = Prediction<d>::forever;
    no_facet.kind = Facet_kind::border;
    no_facet.point.fill(none);
    facet_record_.resize(at(table_.facet_bound()), no_facet);
    Cell_record no_cell{};
    no_cell.expiry.fill(never);
    no_cell.until = Prediction<d>::forever;
    cell_record_.resize(at(table_.cell_bound()), no_cell);
}

template <int d>
void Filter<d>::settle(std::span<const Coordinates<d>> x, Move_report& report) {
    resize();
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
    prediction_.clear();
    last_step_.clear();
    settle_here(report);
}

/// Every certificate evaluated afresh at the present positions; the prediction stays what it is.
template <int d>
void Filter<d>::settle_here(Move_report& report) {
    std::copy(position_.begin(), position_.end(), fixed_.begin());
    std::fill(list_.begin(), list_.end(), Expiry_list{});
    spent_ = 0;
    if (embedding_.dimension() != d) {
        std::fill(threshold_.begin(), threshold_.end(), 0.0);
        return;
    }
    repair_.begin(position_);
    repair_.suspect_everything();
    (void)repair_.evaluate();
    failed_.clear();
    renewals_.clear();
    commit(position_);
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
}

template <int d>
double Filter<d>::tolerance(Index v) const {
    const Expiry_list& list = list_[at(v)];
    return std::max(0.0, (list.earliest() - sum_upper(list.base, prediction_.slack())) * (1.0 - 0x1p-50));
}

template <int d>
void Filter<d>::place(Index v, const Coordinates<d>& p) {
    resize();
    position_[at(v)] = fixed_[at(v)] = p;
    list_[at(v)].clear();
    prediction_.anchor(at(v));
}

template <int d>
void Filter<d>::refresh(std::span<const Index> cells, Move_report& report) {
    resize();
    renewals_.clear();
    repair_.begin(position_);
    for (const Index c : cells) {
        repair_.suspect_cell(c);
        for (int i = 0; i <= d; ++i) repair_.suspect_facet(table_.facet(table_.corner(c, i)));
    }
    (void)repair_.evaluate();
    failed_.clear();
    commit(position_);
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
}

template <int d>
void Filter<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    failed_.clear();
    const std::array<Index, 1> movers{v};
    if (!covers(p)) settle(position_, report);  // so far out that nobody can be there: this call will not fail
    if (passes(v, p)) {
        position_[at(v)] = p;
        embedding_.set_point(v, p);
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    failed_.push_back(v);
    const Coordinates<d> old = position_[at(v)];
    position_[at(v)] = p;
    try {
        process(position_, movers, 1, report);
    } catch (...) {
        position_[at(v)] = old;
        throw;
    }
}

template <int d>
void Filter<d>::find_failed(std::span<const Coordinates<d>> x) {
    failed_.clear();
    const Index n = table_.vertex_bound();
    if (prediction_.active()) {
        for (Index v = 0; v < n; ++v) {
            const Coordinates<d> f = prediction_.expected(at(v), fixed_[at(v)]);
            if (squared_distance<d>(x[at(v)], f) < threshold_[at(v)]) [[likely]]
                continue;
            if ((x[at(v)] == f && prediction_.rests(at(v))) || table_.corner_of(v) == none) continue;
            failed_.push_back(v);
        }
        return;
    }
    for (Index v = 0; v < n; ++v) {
        if (squared_distance<d>(x[at(v)], fixed_[at(v)]) < threshold_[at(v)]) [[likely]]
            continue;
        if (x[at(v)] == fixed_[at(v)] || table_.corner_of(v) == none) continue;
        failed_.push_back(v);
    }
}

template <int d>
void Filter<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    if (prediction_.active()) {
        bool far = false;
        for (const auto& p : x) far |= !prediction_.covers(p);
        // What stands at a vacant index does not count.
        for (std::size_t v = 0; far && v < x.size(); ++v)
            if (!prediction_.covers(x[v]) && table_.corner_of(static_cast<Index>(v)) != none) {
                settle(position_, report);
                far = false;
            }
    }
    prediction_.advance();
    find_failed(x);
    const std::size_t asked = embedding_.vertices();
    note_displacements(x);
    if (failed_.empty() && prediction_.due().empty()) {
        report.moves.asked += asked;
        report.moves.within_tolerance += asked;
        embedding_.set_points(x);
        std::copy(x.begin(), x.end(), position_.begin());
    } else {
        try {
            process(x, {}, asked, report);
        } catch (...) {
            prediction_.retreat();
            last_step_.clear();
            throw;
        }
    }
    prediction_.forget_due();
    reconsider(report);
}

template <int d>
void Filter<d>::look_at(Index id, Index v, double reading, Expiry_list& list, std::span<const Coordinates<d>> x) {
    if (id & 1) {
        const Index c = id >> 1;
        if (at(c) >= cell_record_.size() || !table_.is_cell(c)) return;
        const int i = table_.slot(c, v);
        if (i < 0) return;
        const double expiry = cell_record_[at(c)].expiry[static_cast<std::size_t>(i)];
        if (reading < expiry) {
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
        if (reading < r.expiry[k]) {
            list.put(id, r.expiry[k]);
        } else if (look_ != Second_look::off && second_look(f, x)) {
            list.put(id, look_ == Second_look::safe_region ? sum_lower(reading, renewals_.back().expiry[k])
                                                          : renewals_.back().expiry[k]);
        } else {
            repair_.suspect_facet(f, r.kind, r.point);
        }
        return;
    }
}

/// The expiry of v in a record, without branches: which point v is cannot be predicted.
template <std::size_t k>
double expiry_of(Index v, const std::array<Index, k>& point, const std::array<double, k>& expiry) {
    double e = never;
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
    table_.for_each_corner(v, [&](Index h) {
        const Index c = table_.cell_of(h);
        const Index link = table_.facet(h);
        const Index spoke = table_.facet(table_.ccw(h));
        const Facet_record& l = facet_record_[at(link)];
        const Facet_record& s = facet_record_[at(spoke)];
        certificates_.push_back({cell_record_[at(c)].expiry[static_cast<std::size_t>(table_.slot_of(h))], id_of_cell(c)});
        certificates_.push_back({expiry_of(v, l.point, l.expiry), id_of_facet(link)});
        certificates_.push_back({expiry_of(v, s.point, s.expiry), id_of_facet(spoke)});
    });
    for (const auto& [expiry, id] : certificates_) {
        if (reading < expiry) {
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
    if (10 * failed_.size() < 7 * x.size()) return false;
    const std::size_t stride = 1 + failed_.size() / 256;
    std::size_t sampled = 0;
    std::size_t far = 0;
    for (std::size_t i = 0; i < failed_.size(); i += stride) {
        const Index v = failed_[i];
        ++sampled;
        far += squared_distance<d>(x[at(v)], fixed_position(v)) > 4.0 * threshold_[at(v)] ? 1 : 0;
    }
    return 4 * far > 3 * sampled;
}

template <int d>
void Filter<d>::find_expired(std::span<const Coordinates<d>> x) {
    failed_list_.clear();
    if (most_expired(x)) {
        repair_.suspect_everything();
        for (const Index v : failed_) {
            Expiry_list list;
            list.base = reading(v, x[at(v)]);
            failed_list_.push_back(list);
        }
        return;
    }
    for (const Index v : failed_) {
        Expiry_list list = list_[at(v)];
        list.base = reading(v, x[at(v)]);
        while (!list.empty() && !(list.base < list.earliest())) look_at(list.pop(), v, list.base, list, x);
        if (!(list.base < list.rest())) tour(v, list.base, list, x);
        failed_list_.push_back(list);
    }
    for (const Index id : prediction_.due()) {
        if (id & 1) {
            const Index c = id >> 1;
            if (table_.is_cell(c) && cell_record_[at(c)].until + 1 == prediction_.now()) repair_.suspect_cell(c);
        } else {
            const Index f = id >> 1;
            const Facet_record& r = facet_record_[at(f)];
            if (table_.is_facet(f) && r.until + 1 == prediction_.now()) repair_.suspect_facet(f, r.kind, r.point);
        }
    }
}

template <int d>
void Filter<d>::process(std::span<const Coordinates<d>> x, std::span<const Index> movers, std::size_t asked,
                        Move_report& report) {
    ++epoch_;
    renewals_.clear();
    repair_.begin(x, movers.empty());
    tours_ = 0;
    find_expired(x);
    auto outcome = Repair<d>::Outcome::flipped;
    if (!repair_.evaluate()) outcome = repair_.mend(position_, movers);
    // From here on nothing throws.
    report += repair_.report();
    list_changes(report);
    spent_ += failed_.size();
    report.renewed += renewals_.size();
    report.tours += tours_;
    count(asked, outcome, report);
    if (outcome == Repair<d>::Outcome::rebuilt) {
        settle(x, report);
        return;
    }
    commit(x);
    if (outcome == Repair<d>::Outcome::flipped) {
        if (movers.empty()) {
            embedding_.set_points(x);
        } else {
            for (const Index v : movers) embedding_.set_point(v, x[at(v)]);
        }
    }
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
}

template <int d>
void Filter<d>::count(std::size_t asked, typename Repair<d>::Outcome outcome, Move_report& report) {
    report.moves.asked += asked;
    if (outcome == Repair<d>::Outcome::rebuilt) {
        report.moves.rebuilt += asked;
        return;
    }
    std::size_t left = asked;
    const auto once = [this](Index v) {
        if (disturbed_stamp_[at(v)] == epoch_) return false;
        disturbed_stamp_[at(v)] = epoch_;
        return true;
    };
    for (const Index v : repair_.reinserted()) {
        if (!once(v)) continue;
        ++report.moves.reinserted;
        --left;
    }
    // Marks the disturbed that are not reinserted; those of them that failed were flipped.
    for (const Index v : repair_.disturbed())
        if (disturbed_stamp_[at(v)] != epoch_) disturbed_stamp_[at(v)] = epoch_ + 1;
    for (const Index v : failed_) {
        const std::uint64_t stamp = disturbed_stamp_[at(v)];
        if (stamp == epoch_) continue;
        ++(stamp == epoch_ + 1 ? report.moves.flipped : report.moves.kept_in_place);
        --left;
    }
    report.moves.within_tolerance += left;
    ++epoch_;  // so that the second mark is a mark of this step too
}

template <int d>
void Filter<d>::anchor(Index v, std::span<const Coordinates<d>> x) {
    if (stamp_[at(v)] == epoch_) return;
    stamp_[at(v)] = epoch_;
    anchored_.push_back(v);
    const double now = reading(v, x[at(v)]);
    if (x[at(v)] == fixed_position(v) && prediction_.rests(at(v))) return;
    list_[at(v)].base = now;
    fixed_[at(v)] = x[at(v)];
    prediction_.anchor(at(v));
}

/// Gives a certificate evaluated at x its term and expiries and tells its points.
template <int d>
template <class S>
auto Filter<d>::commit_points(const S& s, Index id, std::span<double> expiry, std::span<const Coordinates<d>> x)
    -> Time {
    const auto term = prediction_.term(s.point, s.verdict.tolerance);
    for (std::size_t k = 0; k < s.point.size(); ++k) {
        if (s.point[k] == none) continue;
        anchor(s.point[k], x);
        Expiry_list& list = list_[at(s.point[k])];
        expiry[k] = sum_lower(list.base, term.tolerance);
        list.put(id, expiry[k]);
    }
    prediction_.schedule(id, term.until);
    return term.until;
}

template <int d>
void Filter<d>::commit(std::span<const Coordinates<d>> x) {
    ++epoch_;
    resize();
    anchored_.clear();
    for (std::size_t i = 0; i < failed_.size(); ++i) {
        const Index v = failed_[i];
        stamp_[at(v)] = epoch_;
        anchored_.push_back(v);
        list_[at(v)] = failed_list_[i];
        fixed_[at(v)] = x[at(v)];
        prediction_.anchor(at(v));
    }
    for (const Index v : repair_.reinserted()) list_[at(v)].clear();
    for (const Renewal& renewal : renewals_) {
        if (!table_.is_facet(renewal.facet)) continue;
        Facet_record& r = facet_record_[at(renewal.facet)];
        r.expiry = renewal.expiry;
        if (look_ == Second_look::unequal_moves) r.tolerance = 0.0;
        for (std::size_t k = 0; k < r.point.size(); ++k) {
            if (look_ == Second_look::safe_region) {  // the room is around the present position
                anchor(r.point[k], x);
                r.expiry[k] = sum_lower(list_[at(r.point[k])].base, renewal.expiry[k]);
            }
            list_[at(r.point[k])].put(id_of_facet(renewal.facet), r.expiry[k]);
            if (stamp_[at(r.point[k])] != epoch_) set_threshold(r.point[k]);
        }
    }
    for (const auto& s : repair_.facets()) {
        if (!repair_.exists(s)) continue;
        Facet_record& r = facet_record_[at(s.id)];
        r.point = s.point;
        r.kind = s.kind;
        r.tolerance = s.verdict.tolerance;
        r.expiry.fill(never);
        r.until = Prediction<d>::forever;
        if (look_ == Second_look::safe_region && s.kind == Facet_kind::empty_sphere) keep_delimiter(s.id, s.point, x);
        if (s.kind != Facet_kind::border) r.until = commit_points(s, id_of_facet(s.id), r.expiry, x);
    }
    for (const auto& s : repair_.cells()) {
        if (!repair_.exists(s)) continue;
        Cell_record& r = cell_record_[at(s.id)];
        r.expiry.fill(never);
        r.until = Prediction<d>::forever;
        if (s.kind != Facet_kind::border && repair_.kind() != Tolerance_kind::paper)
            r.until = commit_points(s, id_of_cell(s.id), r.expiry, x);
    }
    for (const Index v : anchored_) set_threshold(v);
    failed_.clear();
    renewals_.clear();
}

template class Filter<2>;

}  // namespace annulus
