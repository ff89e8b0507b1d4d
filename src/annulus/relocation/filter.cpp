// SPDX-License-Identifier: GPL-3.0-or-later
// A step of `filter`: who failed, what became of it.
#include <annulus/relocation/filter.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/error.h>

#include <algorithm>
#include <experimental/simd>

namespace annulus {

template <int d>
double Filter<d>::tolerance(Index v) const {
    return std::max(0.0, slack(v));
}

template <int d>
void Filter<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    const bool tracked = tracks_;
    if (!tracks_) settle(position_, report);
    try {
        move_one(v, p, report);
    } catch (...) {
        if (!tracked) stop_tracking();
        throw;
    }
}

template <int d>
void Filter<d>::move_one(Index v, const Coordinates<d>& p, Move_report& report) {
    failed_.clear();
    const std::array<Index, 1> movers{v};
    if (tracks_ ? passes(v, p) : p == position_[at(v)]) {
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
        process(position_, movers, tracks_ ? Scope::expired : Scope::star, report);
    } catch (const Error& e) {
        position_[at(v)] = old;
        if (e.code() == Error_code::collision) renew_restored();
        throw;
    } catch (...) {
        position_[at(v)] = old;
        throw;
    }
}

/// The one pass over all vertices. False, with `failed_` unspecified, when a coordinate is outside the domain (or is none at
/// all), be it at a vacant index.
template <int d>
bool Filter<d>::find_failed(std::span<const Coordinates<d>> x) {
    using Vector = std::experimental::fixed_size_simd<double, d>;
    constexpr std::experimental::element_aligned_tag elements;
    failed_.clear();
    const Vertex_record<d>* const record = vertex_.data();
    Vector farthest(0.0);  // by coordinate; may miss what is no number, which fails below
    bool near = true;
    if (tracks_) {
        for (std::size_t v = 0; v < x.size(); ++v) {
            const Vertex_record<d>& r = record[v];
            const Vector p(x[v].data(), elements);
            farthest = max(farthest, abs(p));
            const Vector fixed(r.fixed.data(), elements);
            const Vector off = (p - fixed) * (p - fixed);
            double squares = off[0];
            for (std::size_t k = 1; k < static_cast<std::size_t>(d); ++k) squares += off[k];
            if (squares < r.threshold.value()) [[likely]]
                continue;
            near &= within(x[v], coordinate_limit);
            if (x[v] == r.fixed || table_.corner_of(static_cast<Index>(v)) == none) continue;
            failed_.push_back(static_cast<Index>(v));
        }
    } else {
        for (std::size_t v = 0; v < x.size(); ++v) {
            near &= within(x[v], coordinate_limit);
            if (x[v] != position_[v] && table_.corner_of(static_cast<Index>(v)) != none)
                failed_.push_back(static_cast<Index>(v));
        }
    }
    return near && all_of(farthest <= coordinate_limit);
}

/// What stands at a vacant index does not count.
template <int d>
void Filter<d>::require_domain(std::span<const Coordinates<d>> x) const {
    for (std::size_t v = 0; v < x.size(); ++v)
        if (table_.corner_of(static_cast<Index>(v)) != none) require_in_domain(x[v]);
}

template <int d>
void Filter<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    if (!find_failed(x)) require_domain(x);
    const bool everything = !tracks_ || too_dear();
    const std::size_t asked = embedding_.vertices();
    note_displacements(x);
    if (failed_.empty()) {
        report.moves.asked += asked;
        report.moves.within_tolerance += asked;
        embedding_.set_points(x);
        std::copy(x.begin(), x.end(), position_.begin());
    } else {
        try {
            process(x, {}, everything ? Scope::everything : Scope::expired, report);
        } catch (const Error& e) {
            if (e.code() == Error_code::collision) renew_restored();
            throw;
        }
    }
    end_timestamp(false, report);
}

/// Mends after `failed_` is known and commits; x is position_ with the moves made. Positions are written last, so that whoever
/// meets an exception on the way (only a collision is met before anything is changed) can build anew at them.
template <int d>
void Filter<d>::process(std::span<const Coordinates<d>> x, std::span<const Index> movers, Scope scope,
                        Move_report& report) {
    const bool tolerances = scope == Scope::expired;
    renewals_.clear();
    repair_.begin(x, movers.empty());
    tours_ = 0;
    auto outcome = Repair<d>::Outcome::flipped;
    if (tolerances) find_expired(x);
    try {
        const bool holds = scope == Scope::everything ? repair_.evaluate_everything()
                           : scope == Scope::star     ? repair_.evaluate_star(movers[0])
                                                      : repair_.evaluate();
        if (!holds) outcome = repair_.mend(position_, movers);
    } catch (...) {
        if (tolerances) undo_anchoring();
        throw;
    }
    report += repair_.report();
    if (report_changes_) repair_.list_changes(report);
    if (tolerances) {
        failures_ += failed_.size();
        evaluated_ += repair_.report().evaluated;
    }
    report.renewed += renewals_.size();
    report.tours += tours_;
    count(movers.empty() ? embedding_.vertices() : movers.size(), outcome, report);
    if (tolerances && outcome != Repair<d>::Outcome::rebuilt) commit(x);
    if (outcome == Repair<d>::Outcome::flipped) {
        if (movers.empty()) {
            embedding_.set_points(x);
        } else {
            for (const Index v : movers) embedding_.set_point(v, x[at(v)]);
        }
    }
    if (scope == Scope::everything) {
        if (tracks_) stop_tracking();
        ++untracked_;
    } else if (tolerances && outcome == Repair<d>::Outcome::rebuilt) {
        settle(x, report);
    }
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
}

/// After a collision. Flips of space that were taken back leave the cells that they began with, under other numbers:
/// their certificates are evaluated where the vertices are.
template <int d>
void Filter<d>::renew_restored() {
    if constexpr (d == 3) {
        std::vector<Index> cells;
        for (const Index c : repair_.changed_cells())
            if (table_.is_cell(c)) cells.push_back(c);
        Move_report nobody_asked;
        if (!cells.empty()) refresh(cells, nobody_asked);
    }
}

template <int d>
void Filter<d>::count(std::size_t asked, typename Repair<d>::Outcome outcome, Move_report& report) {
    report.moves.asked += asked;
    if (outcome == Repair<d>::Outcome::rebuilt) {
        report.moves.rebuilt += asked;
        return;
    }
    if (step_ >= Horizons::stamps - 3) {  // the sum would wrap before it was compared
        std::fill(disturbed_stamp_.begin(), disturbed_stamp_.end(), 0);
        step_ = 0;
    }
    step_ += 2;  // its mark, and the one above it
    std::size_t left = asked;
    const auto once = [this](Index v) {
        if (disturbed_stamp_[at(v)] == step_) return false;
        disturbed_stamp_[at(v)] = step_;
        return true;
    };
    for (const Index v : repair_.reinserted()) {
        if (!once(v)) continue;
        ++report.moves.reinserted;
        --left;
    }
    // Marks the disturbed that are not reinserted; those of them that failed were flipped.
    for (const Index v : repair_.disturbed())
        if (disturbed_stamp_[at(v)] != step_) disturbed_stamp_[at(v)] = step_ + 1;
    for (const Index v : failed_) {
        const std::uint32_t stamp = disturbed_stamp_[at(v)];
        if (stamp == step_) continue;
        ++(stamp == step_ + 1 ? report.moves.flipped : report.moves.kept_in_place);
        --left;
    }
    report.moves.within_tolerance += left;
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
