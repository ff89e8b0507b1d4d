// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/relocation/moving_delaunay.h>

#include <algorithm>
#include <cmath>

namespace annulus {

template <class Cgal>
void Moving_delaunay<Cgal>::require_vertex(Index i) const {
    if (i < 0 || at(i) >= index_bound() || embedding_.handle(i) == Vertex_handle())
        throw Error(Error_code::unknown_vertex, "no vertex has index " + std::to_string(i));
}

template <class Cgal>
void Moving_delaunay<Cgal>::refuse_handle() {
    throw Error(Error_code::unknown_vertex, "the handle names no vertex of this triangulation");
}

template <class Cgal>
Moving_delaunay<Cgal>::Moving_delaunay(std::span<const Coordinates<d>> points, const Options& options)
    : options_(options),
      strategy_(options.strategy),
      filter_(embedding_, options.tolerance, options.second_look),
      filter_each_(embedding_, options.tolerance),
      random_(options.seed) {
    require_sound_environment();
    filter_.report_changes(options.report_changes);
    filter_each_.report_changes(options.report_changes);
    for (const auto& p : points) require_in_domain(p);
    std::vector<Coordinates<d>> distinct;
    index_of_input_.reserve(points.size());
    if (options.merge_duplicates) {
        std::map<Coordinates<d>, Index> seen;
        for (auto p : points) {
            for (double& c : p) c += 0.0;  // -0 and 0 are one place
            const auto [it, fresh] = seen.emplace(p, static_cast<Index>(distinct.size()));
            if (fresh) distinct.push_back(p);
            index_of_input_.push_back(it->second);
        }
    } else {
        distinct.assign(points.begin(), points.end());
        for (std::size_t i = 0; i < points.size(); ++i) index_of_input_.push_back(static_cast<Index>(i));
    }
    embedding_.build(distinct);
    plain_ = std::move(distinct);
    Move_report report;
    settle_into(report);
}

template <class Cgal>
auto Moving_delaunay<Cgal>::positions() const -> std::span<const Coordinates<d>> {
    return filters() ? filter_.positions() : filters_each() ? filter_each_.positions() : plain_;
}

/// Hands positions and triangulation to the strategy in force as given and Delaunay.
template <class Cgal>
void Moving_delaunay<Cgal>::settle_into(Move_report& report) {
    if (!filters() && !filters_each()) return;
    if (!embedding_.mirrored()) embedding_.mirror();
    const std::vector<Coordinates<d>> x = std::move(plain_);
    plain_.clear();
    if (filters()) {
        filter_.settle(x, report);
    } else {
        filter_each_.settle(x, report);
    }
}

template <class Cgal>
Move_report Moving_delaunay<Cgal>::settle() {
    Move_report report;
    if (options_.tolerance != Tolerance_kind::certified) {
        make_trusted(report);
        return report;
    }
    if (filters()) filter_.settle(filter_.positions(), report);
    if (filters_each()) filter_each_.settle(filter_each_.positions(), report);
    return report;
}

template <class Cgal>
void Moving_delaunay<Cgal>::rebuild_all(std::span<const Coordinates<d>> x, Move_report& report) {
    embedding_.rebuild(x);
    report.handle_seconds += embedding_.handle_seconds();
    report.moves.asked += number_of_vertices();
    report.moves.rebuilt += number_of_vertices();
    list_everything(report);
    if (filters()) {
        filter_.settle(x, report);
    } else if (filters_each()) {
        filter_each_.settle(x, report);
    } else {
        plain_.assign(x.begin(), x.end());
    }
}

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
        plain_ = std::move(x);
        list_everything(report);
        return;
    }
    const bool in_place = strategy_ == Strategy::in_place && embedding_.update_in_place(i, p);
    if (!in_place) {
        const bool done =
            strategy_ == Strategy::relocate_flips ? embedding_.relocate_by_flips(i, p) : embedding_.relocate(i, p);
        if (!done) throw refused();
    }
    ++report.moves.asked;
    ++(in_place                                ? report.moves.kept_in_place
       : strategy_ == Strategy::relocate_flips ? report.moves.flipped
                                               : report.moves.reinserted);
    plain_[at(i)] = p;
    if (!in_place) list_everything(report);
}

template <class Cgal>
Move_report Moving_delaunay<Cgal>::move(Index i, const Coordinates<d>& p) {
    require_vertex(i);
    require_in_domain(p);
    Move_report report;
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
    return report;
}

/// A timestamp under a strategy that moves one vertex at a time. A position that another vertex has yet to leave is
/// no collision of the timestamp: such vertices are moved last, and when that does not help (a cycle) all is rebuilt.
template <class Cgal>
void Moving_delaunay<Cgal>::try_move_each(std::span<const Coordinates<d>> x, Move_report& report) {
    std::vector<Index> waiting;
    for (Index i = 0; at(i) < x.size(); ++i)
        if (embedding_.handle(i) != Vertex_handle()) waiting.push_back(i);
    std::vector<Index> refused;
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
            }
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
    if (filters()) filter_.begin_each(x);
    try {
        try_move_each(x, report);
    } catch (const Error&) {
        embedding_.rebuild(filters_each() ? each.fixed : old);
        if (filters()) {
            Move_report nobody_asked;
            filter_.settle(old, nobody_asked);
        } else if (filters_each()) {
            filter_each_.restore(each);
        } else {
            plain_ = std::move(old);
        }
        throw;
    }
    if (filters()) filter_.end_each(report);
}

/// CGAL inserts into and removes from Delaunay triangulations only; tolerances that are not certified may have left
/// another, or one at other positions.
template <class Cgal>
void Moving_delaunay<Cgal>::make_trusted(Move_report& report) {
    if (options_.tolerance == Tolerance_kind::certified || (!filters() && !filters_each())) return;
    const std::vector<Coordinates<d>> x(positions().begin(), positions().end());
    embedding_.rebuild(x);
    filters() ? filter_.settle(x, report) : filter_each_.settle(x, report);
}

template <class Cgal>
Move_report Moving_delaunay<Cgal>::move_all(std::span<const Coordinates<d>> points) {
    if (points.size() != index_bound())
        throw Error(Error_code::wrong_size, "move_all takes " + std::to_string(index_bound()) + " points, not " +
                                                std::to_string(points.size()));
    // The filter looks at every position anyway and finds out itself.
    if (strategy_ != Strategy::filter || embedding_.dimension() != d)
        for (std::size_t i = 0; i < points.size(); ++i)
            if (embedding_.handle(static_cast<Index>(i)) != Vertex_handle()) require_in_domain(points[i]);
    Move_report report;
    if (strategy_ == Strategy::hybrid && steps_++ % 4 == 0) consider_switch(points);
    if (strategy_ == Strategy::rebuild || strategy_ == Strategy::hybrid || (filters() && embedding_.dimension() != d)) {
        rebuild_all(points, report);
    } else if (strategy_ == Strategy::filter) {
        filter_.move_all(points, report);
    } else {
        move_each(points, report);
    }
    return report;
}

/// The paper's switch (4.2): of 40 random vertices 75 % (55 % in 3D) have a tolerance above their displacement.
template <class Cgal>
void Moving_delaunay<Cgal>::consider_switch(std::span<const Coordinates<d>> x) {
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
    Move_report report;
    settle_into(report);
}

template <class Cgal>
double Moving_delaunay<Cgal>::star_tolerance(Index i) const {
    if (embedding_.dimension() != d) return 0.0;
    return embedding_.star_tolerance(i);
}

template <class Cgal>
double Moving_delaunay<Cgal>::tolerance(Vertex_handle v) const {
    const Index i = index(v);
    if (embedding_.dimension() != d) return 0.0;
    if (filters() && filter_.tracks()) return filter_.tolerance(i);
    return filters_each() ? filter_each_.tolerance(i) : star_tolerance(i);
}

template <class Cgal>
typename Moving_delaunay<Cgal>::Vertex_handle Moving_delaunay<Cgal>::vertex(std::size_t i) const {
    if (i >= index_bound()) throw Error(Error_code::unknown_vertex, "no vertex has index " + std::to_string(i));
    return embedding_.handle(static_cast<Index>(i));
}

template <class Cgal>
typename Moving_delaunay<Cgal>::Vertex_handle Moving_delaunay<Cgal>::insert(const Point& p, Move_report* out) {
    const Coordinates<d> x = Cgal::coordinates(p);
    require_in_domain(x);
    Move_report report;
    make_trusted(report);
    const Index i = vacant_.empty() ? static_cast<Index>(index_bound()) : vacant_.back();
    std::vector<Index> changed;
    const int before = embedding_.dimension();
    if (!embedding_.insert(i, x, changed)) throw Error(Error_code::collision, "another vertex is at that position");
    if (!vacant_.empty()) vacant_.pop_back();
    if (!filters() && !filters_each()) {
        if (at(i) >= plain_.size()) plain_.resize(at(i) + 1);
        plain_[at(i)] = x;
    } else {
        filters() ? filter_.place(i, x) : filter_each_.place(i, x);
        if (before != d || (filters() && !filter_.covers(x))) {
            report += settle();
        } else {
            filters() ? filter_.refresh(changed, report) : filter_each_.refresh(changed, report);
        }
    }
    list_changes(report, changed);
    if (out) *out = report;
    return embedding_.handle(i);
}

template <class Cgal>
void Moving_delaunay<Cgal>::remove(Vertex_handle v, Move_report* out) {
    const Index i = index(v);
    Move_report report;
    make_trusted(report);
    std::vector<Index> changed;
    embedding_.remove(i, changed);
    vacant_.push_back(i);
    if (filters() || filters_each()) {
        if (changed.empty()) {
            report += settle();
        } else {
            filters() ? filter_.refresh(changed, report) : filter_each_.refresh(changed, report);
        }
    }
    list_changes(report, changed);
    if (out) *out = report;
}

/// For the strategies that leave the book-keeping to CGAL: whatever may have changed, which is every finite cell.
template <class Cgal>
void Moving_delaunay<Cgal>::list_everything(Move_report& report) const {
    if (!options_.report_changes) return;
    report.changed.clear();
    embedding_.for_each_finite_cell(
        [&](const auto& cell) { report.changed.insert(report.changed.end(), cell.begin(), cell.end()); });
}

template <class Cgal>
void Moving_delaunay<Cgal>::list_changes(Move_report& report, std::span<const Index> cells) const {
    if (!options_.report_changes) return;
    if (cells.empty()) {
        list_everything(report);
        return;
    }
    for (const Index c : cells)
        for (int k = 0; k <= d; ++k)
            report.changed.push_back(embedding_.table().vertex(embedding_.table().corner(c, k)));
}

template <class Cgal>
auto Moving_delaunay<Cgal>::audit_input() const -> Audit_input<d> {
    Audit_input<d> input;
    std::vector<Index> squeezed(index_bound(), none);
    for (std::size_t i = 0; i < index_bound(); ++i) {
        if (embedding_.handle(static_cast<Index>(i)) == Vertex_handle()) continue;
        squeezed[i] = static_cast<Index>(input.points.size());
        input.points.push_back(positions()[i]);
    }
    embedding_.for_each_finite_cell([&](const std::array<Index, static_cast<std::size_t>(d + 1)>& cell) {
        auto c = cell;
        for (Index& v : c)
            if (v != none) v = squeezed[at(v)];
        input.cells.push_back(c);
    });
    return input;
}

}  // namespace annulus
