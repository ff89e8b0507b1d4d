// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/relocation/filter.h>

#include <algorithm>

namespace annulus {

namespace {
constexpr double never = std::numeric_limits<double>::infinity();
}  // namespace

template <int d>
void Filter<d>::resize() {
    const auto& t = embedding_.table();
    const std::size_t n = at(t.vertex_bound());
    position_.resize(n);
    fixed_.resize(n);
    threshold_.resize(n, 0.0);
    base_.resize(n, 0.0);
    earliest_.resize(n, never);
    stamp_.resize(n, 0);
    disturbed_stamp_.resize(n, 0);
    Facet_record no_facet{};
    no_facet.expiry.fill(never);
    no_facet.kind = Facet_kind::border;
    no_facet.point.fill(none);
    facet_record_.resize(at(t.facet_bound()), no_facet);
    Cell_record no_cell{};
    no_cell.expiry.fill(never);
    cell_record_.resize(at(t.cell_bound()), no_cell);
}

template <int d>
void Filter<d>::settle(std::span<const Coordinates<d>> x, Move_report& report) {
    resize();
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
    std::copy(position_.begin(), position_.end(), fixed_.begin());
    std::fill(base_.begin(), base_.end(), 0.0);
    std::fill(earliest_.begin(), earliest_.end(), never);
    if (embedding_.dimension() != d) {
        std::fill(threshold_.begin(), threshold_.end(), 0.0);
        return;
    }
    repair_.begin(position_);
    repair_.suspect_everything();
    (void)repair_.evaluate();
    failed_.clear();
    commit(position_);
    report.evaluated += repair_.report().evaluated;
    report.arithmetic += repair_.report().arithmetic;
}

template <int d>
double Filter<d>::tolerance(Index v) const {
    const double slack = (earliest_[at(v)] - base_[at(v)]) * (1.0 - 0x1p-50);
    return std::max(0.0, slack);
}

template <int d>
void Filter<d>::place(Index v, const Coordinates<d>& p) {
    resize();
    position_[at(v)] = fixed_[at(v)] = p;
    earliest_[at(v)] = never;
}

template <int d>
void Filter<d>::refresh(std::span<const Index> cells, Move_report& report) {
    const auto& t = embedding_.table();
    resize();
    repair_.begin(position_);
    for (const Index c : cells) {
        if (repair_.kind() != Tolerance_kind::paper) repair_.suspect_cell(c);
        for (int i = 0; i <= d; ++i) repair_.suspect_facet(t.facet(t.corner(c, i)));
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
void Filter<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    failed_.clear();
    const auto& t = embedding_.table();
    const Index n = t.vertex_bound();
    for (Index v = 0; v < n; ++v) {
        if (squared_distance<d>(x[at(v)], fixed_[at(v)]) < threshold_[at(v)]) [[likely]]
            continue;
        if (x[at(v)] == fixed_[at(v)] || t.corner_of(v) == none) continue;
        failed_.push_back(v);
    }
    const std::size_t asked = embedding_.vertices();
    if (!failed_.empty()) {
        process(x, {}, asked, report);
        return;
    }
    report.moves.asked += asked;
    report.moves.within_tolerance += asked;
    embedding_.set_points(x);
    std::copy(x.begin(), x.end(), position_.begin());
}

template <int d>
void Filter<d>::find_expired(std::span<const Coordinates<d>> x) {
    const auto& t = embedding_.table();
    failed_reading_.resize(failed_.size());
    failed_earliest_.resize(failed_.size());
    for (std::size_t i = 0; i < failed_.size(); ++i) {
        const Index v = failed_[i];
        const double reading = sum_upper(base_[at(v)], distance_upper<d>(x[at(v)], fixed_[at(v)]));
        double earliest = never;
        const auto look_at_facet = [&](Index f) {
            const Facet_record& r = facet_record_[at(f)];
            for (std::size_t k = 0; k < r.point.size(); ++k) {
                if (r.point[k] != v) continue;
                if (reading < r.expiry[k]) {
                    earliest = std::min(earliest, r.expiry[k]);
                } else if (look_ == Second_look::unequal_moves && second_look(f, x)) {
                    earliest = std::min(earliest, facet_record_[at(f)].expiry[k]);
                } else {
                    repair_.suspect_facet(f, r.kind, r.point);
                }
            }
        };
        t.for_each_corner(v, [&](Index h) {
            const Index c = t.cell_of(h);
            const Cell_record& r = cell_record_[at(c)];
            const double expiry = r.expiry[static_cast<std::size_t>(t.slot_of(h))];
            if (reading < expiry) {
                earliest = std::min(earliest, expiry);
            } else {
                repair_.suspect_cell(c);
            }
            look_at_facet(t.facet(h));
            look_at_facet(t.facet(t.ccw(h)));
        });
        failed_reading_[i] = reading;
        failed_earliest_[i] = earliest;
    }
}

/// Whether facet f's certificate is proved at x by the unequal moves of its two sides (theory 2): the sides travelled
/// dA and dB since the reference at most, and dA + dB < width. What is left of the width is shared: `renewals_` gets
/// new expiries ref + dA + rest / 2 and ref + dB + rest / 2, which commit() writes. A renewed record has tolerance 0:
/// its next failure is an evaluation.
template <int d>
bool Filter<d>::second_look(Index f, std::span<const Coordinates<d>> x) {
    const Facet_record& r = facet_record_[at(f)];
    if (r.kind != Facet_kind::empty_sphere || !(r.tolerance > 0.0)) return false;
    std::array<double, 2> travelled{};
    Renewal renewal{f, {}};
    for (std::size_t k = 0; k < r.point.size(); ++k) {
        const std::size_t w = at(r.point[k]);
        const double reading = sum_upper(base_[w], distance_upper<d>(x[w], fixed_[w]));
        // expiry <= reference + tolerance, so this is at least reading - reference up to rounding, which is added.
        const double expired = r.expiry[k] - r.tolerance;
        const double way = (reading - expired) + (reading + r.tolerance) * 0x1p-50;
        double& side = travelled[k < static_cast<std::size_t>(d) ? 0 : 1];
        side = std::max(side, way);
    }
    const double rest = 2.0 * r.tolerance - (travelled[0] + travelled[1]) * (1.0 + 0x1p-50);
    if (!(rest > 0.25 * r.tolerance)) return false;  // too little to live on until the next step
    for (std::size_t k = 0; k < r.point.size(); ++k) {
        const double side = travelled[k < static_cast<std::size_t>(d) ? 0 : 1];
        const double reference = r.expiry[k] - r.tolerance;  // rounded: at most one unit above the reference
        const double expiry = reference + (side + 0.5 * rest);
        renewal.expiry[k] = expiry - expiry * 0x1p-50;
    }
    renewals_.push_back(renewal);
    return true;
}

template <int d>
void Filter<d>::process(std::span<const Coordinates<d>> x, std::span<const Index> movers, std::size_t asked,
                        Move_report& report) {
    ++epoch_;
    renewals_.clear();
    repair_.begin(x);
    find_expired(x);
    auto outcome = Repair<d>::Outcome::flipped;
    if (!repair_.evaluate()) outcome = repair_.mend(position_, movers);
    // From here on nothing throws.
    report += repair_.report();
    report.renewed += renewals_.size();
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
    if (x[at(v)] == fixed_[at(v)]) return;
    base_[at(v)] = sum_upper(base_[at(v)], distance_upper<d>(x[at(v)], fixed_[at(v)]));
    fixed_[at(v)] = x[at(v)];
}

template <int d>
void Filter<d>::commit(std::span<const Coordinates<d>> x) {
    ++epoch_;
    resize();
    anchored_.clear();
    const auto& t = embedding_.table();
    for (std::size_t i = 0; i < failed_.size(); ++i) {
        const Index v = failed_[i];
        stamp_[at(v)] = epoch_;
        anchored_.push_back(v);
        base_[at(v)] = failed_reading_[i];
        fixed_[at(v)] = x[at(v)];
        earliest_[at(v)] = failed_earliest_[i];
    }
    for (const Index v : repair_.reinserted()) earliest_[at(v)] = never;
    const auto expire = [this](Index v, double reading) {
        earliest_[at(v)] = std::min(earliest_[at(v)], reading);
    };
    for (const Renewal& renewal : renewals_) {
        if (!t.is_facet(renewal.facet)) continue;
        Facet_record& r = facet_record_[at(renewal.facet)];
        r.tolerance = 0.0;
        r.expiry = renewal.expiry;
        for (std::size_t k = 0; k < r.point.size(); ++k) {
            expire(r.point[k], r.expiry[k]);
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
        if (s.kind == Facet_kind::border) continue;
        for (std::size_t k = 0; k < s.point.size(); ++k) {
            if (s.point[k] == none) continue;
            anchor(s.point[k], x);
            r.expiry[k] = sum_lower(base_[at(s.point[k])], s.verdict.tolerance);
            expire(s.point[k], r.expiry[k]);
        }
    }
    for (const auto& s : repair_.cells()) {
        if (!repair_.exists(s)) continue;
        Cell_record& r = cell_record_[at(s.id)];
        r.tolerance = s.verdict.tolerance;
        r.expiry.fill(never);
        if (s.kind == Facet_kind::border || repair_.kind() == Tolerance_kind::paper) continue;
        for (std::size_t k = 0; k < s.point.size(); ++k) {
            anchor(s.point[k], x);
            r.expiry[k] = sum_lower(base_[at(s.point[k])], s.verdict.tolerance);
            expire(s.point[k], r.expiry[k]);
        }
    }
    for (const Index v : anchored_) set_threshold(v);
    failed_.clear();
    renewals_.clear();
}

template class Filter<2>;

}  // namespace annulus
