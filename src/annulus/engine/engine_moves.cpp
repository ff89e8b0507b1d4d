// SPDX-License-Identifier: GPL-3.0-or-later
// Engine: moves, under every strategy.
#include <annulus/engine/engine.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/engine/displacement.h>
#include <annulus/engine/guarded.h>
#include <annulus/engine/listing_changes.h>
#include <annulus/engine/rebuild_policy.h>
#include <annulus/engine/require_vertices.h>
#include <annulus/error.h>

#include <algorithm>
#include <functional>

namespace annulus::inline v1 {

template <int d>
Move_result Engine<d>::move(Index i, const Point& p) {
    require_vertex(i);
    require_in_domain(p, "vertex", i);
    Move_result report;
    const Point target = p;  // it may be one of positions(), which change meanwhile
    guarded_moves(std::span(&i, 1), std::span(&target, 1),
                  [&] { listing_changes(report, std::span(&i, 1), [&] { move_one(i, target, report); }); });
    return report;
}

/// Strategies that repair the mesh rebuild flat sets, even for a single move.
template <int d>
void Engine<d>::move_one(Index i, const Point& p, Move_result& report) {
    if (!strategy_->repairs() || mesh_.dimension() == d) {
        strategy_->move(i, p, report);
        return;
    }
    std::vector<Point> x(positions().begin(), positions().end());
    x[at(i)] = p;
    const Move_counts before = report.moves;
    rebuild_all(x, report);
    report.moves = before;
    ++report.moves.asked;
    ++report.moves.rebuilt;
}

template <int d>
Move_result Engine<d>::move(std::span<const Index> indices, std::span<const Point> points) {
    if (indices.size() != points.size())
        throw Error(Error_code::wrong_size,
                    std::to_string(indices.size()) + " indices, and " + std::to_string(points.size()) + " points");
    require_vertices(indices, [this](Index i) { return is_vertex(i); });
    require_in_domain(points, "vertex", [&](std::size_t k) { return indices[k]; });
    Move_result report;
    const std::vector<Point> targets(points.begin(), points.end());  // they may be positions(), which change meanwhile
    guarded_moves(indices, targets,
                  [&] { listing_changes(report, indices, [&] { move_some(indices, targets, report); }); });
    return report;
}

/// One by one while the movers are few and their changes local; otherwise as a time step, or from when they have
/// turned out to cost more than a rebuild. If an index is named twice, its last position counts. A mover at the
/// target of another mover is no duplicate point: this, too, is made a time step.
template <int d>
void Engine<d>::move_some(std::span<const Index> indices, std::span<const Point> points, Move_result& report) {
    constexpr std::size_t share = 64;
    // Each mover once, with its last target. What may throw comes before the moves.
    std::vector<std::pair<Index, std::size_t>> movers;
    for (std::size_t k = 0; k < indices.size(); ++k) movers.emplace_back(indices[k], k);
    std::sort(movers.begin(), movers.end(), std::greater<>());
    movers.erase(
        std::unique(movers.begin(), movers.end(), [](const auto& l, const auto& r) { return l.first == r.first; }),
        movers.end());
    std::vector<std::pair<Index, Point>> source;  // of those that were moved, and of the one that failed
    const auto restore_position = [&] {
        for (; !source.empty(); source.pop_back())
            strategy_->restore_position(source.back().first, source.back().second);
    };
    bool too_expensive = false;
    try {
        if (share * movers.size() <= mesh_.vertices() && strategy_->repairs() && mesh_.dimension() == d) {
            source.reserve(movers.size());
            try {
                if (move_one_by_one(movers, points, source, report)) return;
                too_expensive = true;  // or flat, which is rebuilt anyway
            } catch (const Error& e) {
                if (e.code() != Error_code::duplicate_point) throw;
            }
        }
        std::vector<Point> x(positions().begin(), positions().end());
        for (auto it = source.rbegin(); it != source.rend(); ++it) x[at(it->first)] = it->second;
        const std::vector<Point> old = x;
        for (const auto& [i, k] : movers) x[at(i)] = points[k];
        // If most were reinserted, the movers go too far for flips, even in one time step.
        const bool far = 2 * report.moves.reinserted > source.size();
        report.moves = {};
        try {
            if (too_expensive && (far || strategy_->is_sequential())) rebuild_all(x, report);
            else move_everything(x, report);
        } catch (const Error&) {
            Move_result discarded;
            if (!source.empty()) move_everything(old, discarded);
            throw;
        }
    } catch (const Error& e) {
        if (e.code() == Error_code::too_large) restore_position();
        throw;
    } catch (...) {
        restore_position();
        throw;
    }
    count_movers(movers.size(), report.moves);
}

/// Counts only those that were to move in a time step.
template <int d>
void Engine<d>::count_movers(std::uint64_t movers, Move_counts& moves) {
    moves.asked = movers;
    std::uint64_t left = movers;
    for (std::uint64_t* const n : {&moves.kept_in_place, &moves.flipped, &moves.reinserted, &moves.rebuilt}) {
        *n = std::min(*n, left);
        left -= *n;
    }
    moves.within_tolerance = left;
}

/// `source` receives the previous positions. False: the rest would cost more than a rebuild, or the mesh is flat by
/// now.
template <int d>
bool Engine<d>::move_one_by_one(std::span<const std::pair<Index, std::size_t>> movers, std::span<const Point> points,
                                std::vector<std::pair<Index, Point>>& source, Move_result& report) {
    const double before = report.statistics.cost;
    const double rebuild = strategy_->begins_with_tolerances()
                               ? Rebuild_policy<d>::rebuild_with_tolerances_cost(mesh_.vertices())
                               : Rebuild_policy<d>::rebuild_cost(mesh_.vertices());
    for (const auto& [i, k] : movers) {
        if (mesh_.dimension() != d) return false;
        const double cost = report.statistics.cost - before;
        if (!source.empty() &&
            Rebuild_policy<d>::exceeds_rebuild_one_by_one(cost, source.size(), movers.size(), rebuild))
            return false;
        source.emplace_back(i, positions()[at(i)]);
        strategy_->move(i, points[k], report);
    }
    return true;
}

template <int d>
Move_result Engine<d>::move_all(std::span<const Point> points) {
    if (points.size() != index_bound())
        throw Error(Error_code::wrong_size, "move_all takes " + std::to_string(index_bound()) + " points, not " +
                                                std::to_string(points.size()));
    // Strategies that repair whole time steps read every position anyway, and check it themselves.
    if (!strategy_->repairs() || strategy_->is_sequential() || mesh_.dimension() != d)
        require_in_domain(points, "vertex", [this](std::size_t i) {
            return is_vertex(static_cast<Index>(i)) ? static_cast<Index>(i) : none;
        });
    Move_result report;
    guarded_moves({}, points, [&] { listing_all_changes(report, [&] { move_everything(points, report); }); });
    clear_free_positions();
    return report;
}

template <int d>
void Engine<d>::move_everything(std::span<const Point> points, Move_result& report) {
    strategy_->before_step(points, report);
    if (strategy_->repairs() && mesh_.dimension() != d) rebuild_all(points, report);
    else if (strategy_->is_sequential()) move_sequentially(points, report);
    else strategy_->move_all(points, report);
    mesh_.end_step();
}

template <int d>
void Engine<d>::rebuild_all(std::span<const Point> x, Move_result& report) {
    report.statistics.cost += Rebuild_policy<d>::rebuild_cost(mesh_.vertices());
    mesh_.rebuild(x);
    report.moves.asked += mesh_.vertices();
    report.moves.rebuilt += mesh_.vertices();
    strategy_->begin(x, report);
}

/// Orders vertices so that each finds its target left by the vertex that is there, as far as possible (not in a
/// cycle). O(n log n).
template <int d>
void Engine<d>::order_by_blockers(std::span<const Point> x, std::vector<Index>& waiting) const {
    const auto now = positions();
    std::vector<Index> by_place = waiting;
    std::sort(by_place.begin(), by_place.end(), [&](Index l, Index r) { return now[at(l)] < now[at(r)]; });
    const auto blocker = [&](Index i) {
        const auto it = std::lower_bound(by_place.begin(), by_place.end(), x[at(i)],
                                         [&](Index k, const Point& p) { return now[at(k)] < p; });
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

/// A time step under a strategy that moves one vertex at a time. A position that another vertex has yet to leave is
/// no duplicate point of the time step: such vertices are moved last, in an order that is computed once. When that
/// does not help (a cycle), everything is rebuilt.
template <int d>
void Engine<d>::try_move_sequentially(std::span<const Point> x, Move_result& report) {
    std::vector<Index> waiting;
    for (Index i = 0; at(i) < x.size(); ++i)
        if (is_vertex(i)) waiting.push_back(i);
    std::vector<Index> refused;
    bool ordered = false;
    const double before = report.statistics.cost;
    std::size_t turns = 0;
    for (bool progress = true; progress && !waiting.empty();) {
        refused.clear();
        for (const Index i : waiting) {
            if (strategy_->repairs() &&
                (mesh_.dimension() != d || Rebuild_policy<d>::exceeds_rebuild_in_sequence(
                                               report.statistics.cost - before, turns++, mesh_.vertices()))) {
                // Single moves of a flat set are rebuilds, and may be as expensive where many vertices are on one
                // sphere: all at once.
                report.moves = {};
                rebuild_all(x, report);
                return;
            }
            try {
                strategy_->move_sequentially(i, x[at(i)], report);
            } catch (const Error& e) {
                if (e.code() != Error_code::duplicate_point) throw;
                refused.push_back(i);
                if (!ordered) break;
            }
        }
        if (!ordered && !refused.empty()) {  // those that were moved are no longer in the way
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

template <int d>
void Engine<d>::move_sequentially(std::span<const Point> x, Move_result& report) {
    strategy_->begin_transaction(x, report);
    try {
        try_move_sequentially(x, report);
    } catch (const Error& e) {
        strategy_->rollback();
        if (e.code() == Error_code::too_large) throw;
        mesh_.rebuild(strategy_->delaunay_positions());
        strategy_->resume_after_rollback();
        throw;
    } catch (...) {  // the caller rebuilds
        strategy_->rollback();
        throw;
    }
    strategy_->commit_transaction(report);
}

template class Engine<2>;
template class Engine<3>;

}  // namespace annulus::inline v1
