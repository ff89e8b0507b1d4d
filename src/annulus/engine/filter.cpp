// SPDX-License-Identifier: GPL-3.0-or-later
// A step of `filter`: who failed, what became of it.
#include <annulus/engine/filter.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/error.h>

#include <algorithm>

namespace annulus {

template <int d>
void Filter<d>::move(Index v, const Coordinates<d>& p, Move_report& report) {
    if (tracks_) return move_one(v, p, report);
    // Signs around one vertex cost a thousandth of settling, which then pays for those to come (rent or buy).
    constexpr std::uint64_t share = 64;
    if (share * ++single_moves_ > embedding_.vertices()) {
        settle(position_, report);
        try {
            move_one(v, p, report);
        } catch (...) {
            stop_tracking();
            throw;
        }
        return;
    }
    require_mirror();
    move_one(v, p, report);
}

/// A mirror, if there is none because timestamps were rebuilt.
template <int d>
void Filter<d>::require_mirror() {
    if (embedding_.mirrored()) return;
    embedding_.mirror();
    resize();
}

template <int d>
void Filter<d>::move_one(Index v, const Coordinates<d>& p, Move_report& report) {
    failed_.clear();
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
        process_one(v, old, tracks_ ? Scope::expired : Scope::star, report);
    } catch (const Error& e) {
        position_[at(v)] = old;
        if (e.code() == Error_code::collision) renew_renumbered();
        throw;
    } catch (...) {
        position_[at(v)] = old;
        throw;
    }
}

template <int d>
void Filter<d>::move_all(std::span<const Coordinates<d>> x, Move_report& report) {
    if (!embedding_.mirrored()) {
        require_domain(x);
        rebuild_all(x, next_is_mended(x), report);
        return;
    }
    if (!find_failed(x)) require_domain(x);
    const bool everything = !tracks_ || too_dear() || too_many_failed();
    const std::size_t asked = embedding_.vertices();
    note_displacements(x);
    if (failed_.empty()) {
        report.moves.asked += asked;
        report.moves.within_tolerance += asked;
        embedding_.set_points(x);
        std::copy(x.begin(), x.end(), position_.begin());
    } else {
        try {
            process(x, everything ? Scope::everything : Scope::expired, report);
        } catch (const Error& e) {
            if (e.code() == Error_code::collision) renew_renumbered();
            throw;
        }
    }
    if (!embedding_.mirrored()) return;
    if (settles_next_ && !tracks_) settle_afterwards(report);
    end_timestamp(false, report);
}

/// Without a mirror, by what this timestamp brings: whether it will pay to have one. This timestamp is rebuilt all the same, since a
/// mirror, repair that gives up, and then a rebuild would be too much for one.
template <int d>
bool Filter<d>::next_is_mended(std::span<const Coordinates<d>> x) {
    constexpr std::size_t most_cells = 512;
    constexpr std::size_t share = 16;
    const std::size_t cells = std::min(most_cells, 1 + x.size() / share);
    return !chooser_.is_hopeless(embedding_.sample(x, cells / 8)) && chooser_.mends(embedding_.sample(x, cells));
}

template <int d>
void Filter<d>::rebuild_all(std::span<const Coordinates<d>> x, bool mirrors, Move_report& report) {
    embedding_.rebuild(x);
    if (report_changes_) embedding_.list_cells(report.changed);
    if (mirrors) {
        require_mirror();
        report.price += Prices<d>::mirror * static_cast<double>(embedding_.vertices());
    }
    std::copy(x.begin(), x.end(), position_.begin());
    ++report.rebuild_steps;
    report.moves.asked += embedding_.vertices();
    report.moves.rebuilt += embedding_.vertices();
}

/// After repair gave up. A collision, of which CGAL finds out before anything of its own has changed, leaves the cells with other numbers.
template <int d>
void Filter<d>::rebuild(std::span<const Coordinates<d>> x) {
    try {
        if (automatic_) {
            chooser_.gave_up();
            stop_tracking();
            embedding_.drop_mirror();
        }
        embedding_.rebuild(x);
    } catch (const Error&) {
        embedding_.revert();
        renumbered_ = embedding_.mirrored();
        throw;
    }
}

/// What this timestamp cost so far besides the signs that repair asked, in cells looked at.
template <int d>
double Filter<d>::dearer() const {
    if (repair_.kind() == Tolerance_kind::paper) return 0.0;
    const std::size_t evaluated = repair_.facets().size() + repair_.cells().size();
    if (evaluated == 0) return prepared_;
    const Stage_counts& by = repair_.report().arithmetic;
    return prepared_ + Prices<d>::evaluation * static_cast<double>(evaluated) +
           interval_evaluation_price * static_cast<double>(by.interval) + exact_evaluation_price * static_cast<double>(by.exact);
}

/// When so many certificates have expired that their tolerances would cost more than repair may, signs are asked instead.
template <int d>
bool Filter<d>::examine(std::span<const Coordinates<d>> x, Index mover, Scope& scope) {
    renewals_.clear();
    repair_.begin(x, mover == none);
    tours_ = 0;
    prepared_ = 0.0;
    if (scope == Scope::star) return repair_.evaluate_star(mover);
    if (scope == Scope::expired) {
        find_expired(x);
        prepared_ += Prices<d>::failure * static_cast<double>(failed_.size());
        if (mover != none || repair_.kind() == Tolerance_kind::paper || 
            repair_.price() + dearer() <= 0.5 * most_repair()) return repair_.evaluate();
        undo_anchoring();
        renewals_.clear();
        scope = Scope::everything;
        repair_.begin(x, true);
    }
    return repair_.evaluate_everything(most_repair() - prepared_);
}

/// Mends after `failed_` is known and commits; x is position_ with the moves made. Positions are written last, so that whoever
/// meets an exception on the way can build anew at them; a collision is met before anything is committed.
template <int d>
void Filter<d>::process(std::span<const Coordinates<d>> x, Scope scope, Move_report& report) {
    bool rebuilt = false;
    try {
        if (!examine(x, none, scope) && !repair_.mend_all(position_, most_repair() - dearer())) {
            rebuild(x);
            rebuilt = true;
        }
    } catch (...) {
        if (scope == Scope::expired && tracks_) undo_anchoring();
        throw;
    }
    finish(x, none, scope, rebuilt, report);
}

/// The same after v moved from `old` to where position_ has it.
template <int d>
void Filter<d>::process_one(Index v, const Coordinates<d>& old, Scope scope, Move_report& report) {
    bool rebuilt = false;
    try {
        if (!examine(position_, v, scope) && !repair_.mend_one(position_, v, old, most_repair())) {
            rebuild(position_);
            rebuilt = true;
        }
    } catch (...) {
        if (scope == Scope::expired && tracks_) undo_anchoring();
        throw;
    }
    finish(position_, v, scope, rebuilt, report);
}

template <int d>
void Filter<d>::finish(std::span<const Coordinates<d>> x, Index mover, Scope scope, bool rebuilt, Move_report& report) {
    const bool tolerances = scope == Scope::expired;
    report += repair_.report();
    report.price += repair_.price() + dearer();
    if (mover == none) ++(tolerances ? report.tolerance_steps : report.sign_steps);
    if (report_changes_) {
        if (rebuilt) embedding_.list_cells(report.changed);
        else repair_.list_changes(report);
    }
    if (tolerances) {
        failures_ += failed_.size();
        evaluated_ += repair_.report().evaluated;
    }
    report.renewed += renewals_.size();
    report.tours += tours_;
    count(mover, rebuilt, report);
    if (!rebuilt && mover == none) chooser_.mended();
    if (tolerances && !rebuilt) commit(x);
    if (!rebuilt && mover == none) embedding_.set_points(x);
    if (!rebuilt && mover != none) embedding_.set_point(mover, x[at(mover)]);
    if (tolerances && rebuilt && repair_.kind() == Tolerance_kind::paper) {
        settle(x, report);
    } else if (tracks_ && (scope == Scope::everything || rebuilt)) {
        stop_tracking();
    }
    if (!tracks_ && mover == none) ++untracked_;
    if (x.data() != position_.data()) std::copy(x.begin(), x.end(), position_.begin());
}

/// After a collision, when the cells have other numbers than those that records name.
template <int d>
void Filter<d>::renew_renumbered() {
    Move_report nobody_asked;
    if (renumbered_ && tracks_) settle(position_, nobody_asked);
    else if (!repair_.renumbered().empty()) {
        const std::vector<Cell_index> cells(repair_.renumbered().begin(), repair_.renumbered().end());
        refresh(cells, nobody_asked);
    }
    renumbered_ = false;
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
