// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Moving_delaunay: moves, under every strategy.
#include <annulus/cgal/moving_delaunay.h>

#include <algorithm>

namespace annulus {

/// One vertex under the strategies without tolerances.
template <class Cgal>
void Moving_delaunay<Cgal>::move_plain(Index i, const Coordinates<d>& p, Move_report& report) {
    const auto refused = [] { return Error(Error_code::collision, "another vertex is at that position"); };
    if (plain_[at(i)] == p) {
        ++report.moves.asked;
        ++report.moves.within_tolerance;
        return;
    }
    if (strategy_ == Strategy::rebuild || strategy_ == Strategy::hybrid) {
        std::vector<Coordinates<d>> x = plain_;
        x[at(i)] = p;
        embedding_.rebuild(x);
        report.handle_seconds += embedding_.handle_seconds();
        ++report.moves.asked;
        ++report.moves.rebuilt;
        list_everything(report);
        plain_[at(i)] = p;
        return;
    }
    if (strategy_ == Strategy::in_place && embedding_.update_in_place(i, p)) {
        ++report.moves.kept_in_place;
    } else {
        switch (strategy_ == Strategy::relocate_flips ? embedding_.relocate_by_flips(i, p)
                                                      : embedding_.relocate(i, p)) {
            case Relocation::refused: throw refused();
            case Relocation::kept: ++report.moves.kept_in_place; break;
            case Relocation::flipped: ++report.moves.flipped; break;
            case Relocation::reinserted: ++report.moves.reinserted; break;
        }
        list_everything(report);
    }
    ++report.moves.asked;
    plain_[at(i)] = p;
}

template <class Cgal>
Move_report Moving_delaunay<Cgal>::move(Index i, const Coordinates<d>& p) {
    require_vertex(i);
    require_in_domain(p);
    Move_report report;
    guarded([&] { move_unguarded(i, Coordinates<d>(p), report); });
    return report;
}

template <class Cgal>
void Moving_delaunay<Cgal>::move_unguarded(Index i, const Coordinates<d>& p, Move_report& report) {
    if (!filters() && !filters_each()) {
        move_plain(i, p, report);
    } else if (embedding_.dimension() != d) {
        std::vector<Coordinates<d>> x(positions().begin(), positions().end());
        x[at(i)] = p;
        rebuild_all(x, report);
        report.moves = {};
        report.moves.asked = report.moves.rebuilt = 1;
    } else if (filters()) {
        filter_.move(i, p, report);
    } else {
        filter_each_.move(i, p, report);
    }
}

/// Vertices in an order in which each finds its place left by the one that is there, as far as there is one (not in a cycle).
/// O(n log n).
template <class Cgal>
void Moving_delaunay<Cgal>::order_by_blockers(std::span<const Coordinates<d>> x, std::vector<Index>& waiting) const {
    const auto now = positions();
    std::vector<Index> by_place = waiting;
    std::sort(by_place.begin(), by_place.end(), [&](Index l, Index r) { return now[at(l)] < now[at(r)]; });
    const auto blocker = [&](Index i) {
        const auto it = std::lower_bound(by_place.begin(), by_place.end(), x[at(i)],
                                         [&](Index k, const Coordinates<d>& p) { return now[at(k)] < p; });
        return it != by_place.end() && now[at(*it)] == x[at(i)] && *it != i ? *it : none;
    };
    std::vector<char> done(x.size(), 1);
    for (const Index i : waiting) done[at(i)] = 0;
    std::vector<Index> order;
    std::vector<Index> chain;
    for (const Index first : waiting) {
        for (Index i = first; i != none && done[at(i)] == 0; i = blocker(i)) {
            done[at(i)] = 1;
            chain.push_back(i);
        }
        for (; !chain.empty(); chain.pop_back()) order.push_back(chain.back());
    }
    waiting = std::move(order);
}

/// A timestamp under a strategy that moves one vertex at a time. A position that another vertex has yet to leave is
/// no collision of the timestamp: such vertices are moved last, in an order that is sought once, and when that does not help (a
/// cycle) all is rebuilt.
template <class Cgal>
void Moving_delaunay<Cgal>::try_move_each(std::span<const Coordinates<d>> x, Move_report& report) {
    std::vector<Index> waiting;
    for (Index i = 0; at(i) < x.size(); ++i)
        if (embedding_.handle(i) != Vertex_handle()) waiting.push_back(i);
    std::vector<Index> refused;
    bool ordered = false;
    for (bool progress = true; progress && !waiting.empty();) {
        refused.clear();
        for (const Index i : waiting) {
            if (strategy_ == Strategy::filter_each && embedding_.dimension() != d) {
                // Single moves of a flat set are rebuilds: do them all at once.
                report.moves = {};
                rebuild_all(x, report);
                return;
            }
            try {
                filters()        ? filter_.move_one(i, x[at(i)], report)
                : filters_each() ? filter_each_.move(i, x[at(i)], report)
                                 : move_plain(i, x[at(i)], report);
            } catch (const Error& e) {
                if (e.code() != Error_code::collision) throw;
                refused.push_back(i);
                if (!ordered) break;
            }
        }
        if (!ordered && !refused.empty()) {  // those that were moved are no longer in anybody's way
            ordered = true;
            const auto tried = std::find(waiting.begin(), waiting.end(), refused.back());
            waiting.erase(waiting.begin(), tried);
            order_by_blockers(x, waiting);
            continue;
        }
        progress = refused.size() < waiting.size();
        std::swap(waiting, refused);
    }
    if (waiting.empty()) return;
    report.moves = {};
    rebuild_all(x, report);
}

template <class Cgal>
void Moving_delaunay<Cgal>::move_each(std::span<const Coordinates<d>> x, Move_report& report) {
    typename Filter_each<d>::Snapshot each;
    std::vector<Coordinates<d>> old;
    if (filters_each()) each = filter_each_.save();
    else old.assign(positions().begin(), positions().end());
    if (filters()) filter_.begin_each(x, report);
    try {
        try_move_each(x, report);
    } catch (const Error& e) {
        if (filters()) {
            filter_.restore(old);
        } else if (filters_each()) {
            filter_each_.restore(each);
        } else {
            plain_ = std::move(old);
        }
        if (e.code() == Error_code::too_large) throw;
        embedding_.rebuild(filters_each() ? std::span<const Coordinates<d>>(each.fixed) : positions());
        if (filters()) {
            Move_report nobody_asked;
            filter_.settle(filter_.positions(), nobody_asked);
        }
        throw;
    } catch (...) {  // the caller builds anew at these
        if (filters()) filter_.restore(old);
        else if (filters_each()) filter_each_.restore(each);
        else plain_ = std::move(old);
        throw;
    }
    if (filters()) filter_.end_each(report);
}

template <class Cgal>
Move_report Moving_delaunay<Cgal>::move_all(std::span<const Coordinates<d>> points) {
    if (points.size() != index_bound())
        throw Error(Error_code::wrong_size, "move_all takes " + std::to_string(index_bound()) + " points, not " +
                                                std::to_string(points.size()));
    // The filter looks at every position anyway and finds out itself.
    if ((strategy_ != Strategy::filter && strategy_ != Strategy::automatic) || embedding_.dimension() != d)
        for (std::size_t i = 0; i < points.size(); ++i)
            if (embedding_.handle(static_cast<Index>(i)) != Vertex_handle()) require_in_domain(points[i]);
    Move_report report;
    guarded([&] { move_all_unguarded(points, report); });
    if ((filters() || filters_each()) && !plain_.empty()) plain_ = {};  // not before: they may be what was asked for
    return report;
}

template <class Cgal>
void Moving_delaunay<Cgal>::move_all_unguarded(std::span<const Coordinates<d>> points, Move_report& report) {
    if (strategy_ == Strategy::hybrid && steps_++ % 4 == 0) consider_switch(points, report);
    if (strategy_ == Strategy::rebuild || strategy_ == Strategy::hybrid || (filters() && embedding_.dimension() != d)) {
        rebuild_all(points, report);
    } else if (strategy_ == Strategy::filter || strategy_ == Strategy::automatic) {
        filter_.move_all(points, report);
    } else {
        move_each(points, report);
    }
}

/// The paper's switch (4.2): of 40 random vertices 75 % (55 % in 3D) have a tolerance above their displacement.
template <class Cgal>
void Moving_delaunay<Cgal>::consider_switch(std::span<const Coordinates<d>> x, Move_report& report) {
    constexpr int sample = 40;
    constexpr double share = d == 2 ? 0.75 : 0.55;
    if (embedding_.dimension() != d || number_of_vertices() < 4) return;
    int within = 0;
    for (int k = 0; k < sample; ++k) {
        Index i = 0;
        do i = static_cast<Index>(random_() % plain_.size());
        while (embedding_.handle(i) == Vertex_handle());
        within += distance_upper<d>(x[at(i)], plain_[at(i)]) < star_tolerance(i) ? 1 : 0;
    }
    if (within < share * sample) return;
    strategy_ = Strategy::filter;
    settle_into(report);
}

}  // namespace annulus
