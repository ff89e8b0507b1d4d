// SPDX-License-Identifier: GPL-3.0-or-later
// How `filter` starts, when it keeps tolerances, and its rebuilds.
#include <annulus/engine/filter.h>

#include <annulus/arithmetic/error.h>
#include <annulus/engine/sample.h>

#include <algorithm>
#include <new>
#include <utility>

namespace annulus {

template <int d>
void Filter<d>::resize() {
    const std::size_t n = at(table_.vertex_bound());
    grow(position_, n);
    outcomes_.resize(n);
    if (odometers_.kept()) odometers_.resize();
}

/// The cells are worked on from now on.
template <int d>
void Filter<d>::stop_rebuilding() {
    if (!std::exchange(rebuilding_, false)) return;
    resize();
}

template <int d>
void Filter<d>::settle(std::span<const Coordinates<d>> x, Move_report& report) {
    const bool own = x.data() == position_.data();
    rebuilding_ = false;
    odometers_.invalidate();
    resize();
    if (own) x = position_;
    take_up(x, report);
    if (!own) std::copy(x.begin(), x.end(), position_.begin());
}

/// Fresh tolerances of everything at x.
template <int d>
void Filter<d>::take_up(std::span<const Coordinates<d>> x, Move_report& report) {
    tracking_.settled();
    ++report.settlings;
    odometers_.begin(x);
    if (mesh_.dimension() == d) evaluate_all(x, report);
    odometers_.finish_beginning();
}

template <int d>
void Filter<d>::begin(std::span<const Coordinates<d>> x, Move_report& report) {
    if (means_ == Means::tolerances) return settle(x, report);
    if (x.data() != position_.data()) position_.assign(x.begin(), x.end());
    stop_tracking();
    rebuilding_ = means_ == Means::any;
    if (!rebuilding_) resize();
}

template <int d>
void Filter<d>::refresh_all(Move_report& report) {
    if (means_ == Means::signs) return begin(position_, report);
    settle(position_, report);
}

template <int d>
void Filter<d>::begin_each(std::span<const Coordinates<d>> x, Move_report& report) {
    noted_ = position_;
    settle_if_it_pays(report);
    note_displacements(x);
}

template <int d>
void Filter<d>::end_each(Move_report& report) {
    noted_.clear();
    end_timestamp(true, report);
}

template <int d>
void Filter<d>::take_back() noexcept {
    position_.swap(noted_);
    odometers_.invalidate();
}

template <int d>
void Filter<d>::resume() {
    Move_report nobody_asked;
    refresh_all(nobody_asked);
}

/// In blocks that stay in the cache from the evaluation to what is written down; several threads want larger ones.
/// The order is the same.
template <int d>
void Filter<d>::evaluate_all(std::span<const Coordinates<d>> x, Move_report& report) {
    Checker<d>& checker = repair_.checker();
    const auto in_blocks = [&]<class I>(I bound, auto add) {
        const Index block = threads_ > 1 ? 1 << 16 : 1024;
        for (Index first = 0; first < bound.value(); first += block) {
            checker.begin(x);
            const Index last = std::min(bound.value(), first + block);
            for (I i(first); i.value() < last; ++i) add(i);
            const Stage_counts counts = checker.evaluate();
            odometers_.commit_fresh(checker);
            report.evaluated += counts.total();
            report.arithmetic += counts;
        }
    };
    in_blocks(table_.facet_bound(), [&](Corner_index f) {
        if (table_.is_facet(f)) checker.add_facet(f);
    });
    in_blocks(table_.cell_bound(), [&](Cell_index c) {
        if (table_.is_cell(c)) checker.add_cell(c);
    });
}

/// Tolerances are given up: no vertex that moves passes until the next settling.
template <int d>
void Filter<d>::stop_tracking() {
    odometers_.drop();
    tracking_.stopped();
}

template <int d>
void Filter<d>::place(Index v, const Coordinates<d>& p) {
    if (at(v) >= position_.size()) position_.resize(at(v) + 1);
    position_[at(v)] = p;
    if (rebuilding_) return;
    resize();
    if (odometers_.kept()) odometers_.place(v, p);
}

template <int d>
void Filter<d>::put_back(Index v, const Coordinates<d>& p) noexcept {
    position_[at(v)] = p;
    odometers_.invalidate();
}

template <int d>
void Filter<d>::cut(std::size_t bound) {
    position_.resize(bound);
    odometers_.invalidate();
}

template <int d>
void Filter<d>::refresh(std::span<const Cell_index> cells, Move_report& report) {
    if (rebuilding_) return;
    resize();
    if (!odometers_.kept()) return;
    Step<d> step = new_step(position_, none, Scope::expired);
    odometers_.begin_anchoring(step);
    Checker<d>& checker = repair_.checker();
    checker.begin(position_);
    checker.add_cells(cells);
    const Stage_counts counts = checker.evaluate();
    odometers_.commit(step, checker);
    report.evaluated += counts.total();
    report.arithmetic += counts;
}

/// Displacements are kept from time to time while no tolerances are, unless there never are any.
template <int d>
void Filter<d>::note_displacements(std::span<const Coordinates<d>> x) {
    if (odometers_.kept() || means_ == Means::signs) tracking_.forget_displacements();
    else tracking_.note_displacements(table_, position_, x);
}

template <int d>
void Filter<d>::end_timestamp(bool each, Move_report& report) {
    if (odometers_.kept()) {
        if (tracking_.end_tracked(each, mesh_.vertices())) stop_tracking();
    } else if (each) {
        tracking_.note_untracked();
    }
    tracking_.reconsider(table_, repair_.checker(), position_, each, report);
}

/// At the end of a timestamp that was mended by signs (after a rebuild nothing is settled), not the one that found
/// out: at its beginning nobody knows whether a rebuild is to come. The two cost no more than a timestamp may.
template <int d>
void Filter<d>::settle_afterwards(Move_report& report) {
    static_assert(Chooser<d>::share() + Prices<d>::settling < 1.45 * Prices<d>::insertion);
    try {
        settle_if_it_pays(report);
    } catch (const std::bad_alloc&) {  // the timestamp has been made
    }
}

template <int d>
void Filter<d>::settle_if_it_pays(Move_report& report) {
    if (!tracking_.take_settling()) return;
    report.price += Prices<d>::settling * static_cast<double>(mesh_.vertices());
    settle(position_, report);
}

/// While timestamps are rebuilt, by what this one brings: whether it will pay to mend the next. This one is rebuilt
/// all the same.
template <int d>
bool Filter<d>::next_is_mended(std::span<const Coordinates<d>> x) {
    constexpr std::size_t most_cells = 512;
    constexpr std::size_t share = 16;
    const std::size_t cells = std::min(most_cells, 1 + x.size() / share);
    return !chooser_.is_hopeless(sample_cells<d>(table_, x, cells / 8)) &&
           chooser_.mends(sample_cells<d>(table_, x, cells));
}

template <int d>
void Filter<d>::rebuild_all(std::span<const Coordinates<d>> x, bool last, Move_report& report) {
    report.price += Chooser<d>::rebuild_price(mesh_.vertices());
    mesh_.rebuild(x);
    if (last) stop_rebuilding();
    std::copy(x.begin(), x.end(), position_.begin());
    ++report.rebuild_steps;
    report.moves.asked += mesh_.vertices();
    report.moves.rebuilt += mesh_.vertices();
}

/// After repair gave up. After a collision the cells are built at the old positions, with other numbers.
template <int d>
void Filter<d>::rebuild(Step<d>& step) {
    try {
        if (means_ == Means::any) {
            chooser_.gave_up();
            stop_tracking();
            rebuilding_ = true;
        }
        mesh_.rebuild(step.x);
    } catch (const Error&) {
        if (step.mover != none) position_[at(step.mover)] = step.home;
        mesh_.rebuild(position_);
        step.renumbered_all = !rebuilding_;
        throw;
    }
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
