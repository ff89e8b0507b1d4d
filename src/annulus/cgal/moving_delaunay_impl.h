// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Moving_delaunay: made, kept whole, and what it tells. Moves are in moving_delaunay_moves.h.
#include <annulus/cgal/moving_delaunay.h>

#include <new>

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
      filter_(embedding_, options.tolerance, options.second_look, options.strategy == Strategy::automatic),
      filter_each_(embedding_, options.tolerance),
      random_(options.seed) {
    require_sound_environment();
    filter_.report_changes(options.report_changes);
    filter_each_.report_changes(options.report_changes);
    for (const auto& p : points) require_in_domain(p);
    if (points.size() > Horizons::vertices)
        throw Error(Error_code::too_large, "more than " + std::to_string(Horizons::vertices) + " vertices");
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
    if (filters() || filters_each()) plain_ = {};
}

template <class Cgal>
void Moving_delaunay<Cgal>::require_whole() {
    if (whole_) return;
    recover(index_bound(), none);
    if (!whole_) throw std::bad_alloc();
}

template <class Cgal>
template <class Call>
void Moving_delaunay<Cgal>::guarded(Call call, Index fresh) {
    require_whole();
    const std::size_t bound = index_bound();
    const Strategy strategy = strategy_;
    const auto switch_back = [&] {
        if (strategy_ == strategy) return;
        strategy_ = strategy;  // hybrid
        embedding_.drop_mirror();
    };
    try {
        call();
    } catch (const Error& e) {
        switch_back();
        if (e.code() == Error_code::too_large) recover(bound, fresh);
        throw;
    } catch (...) {
        switch_back();
        recover(bound, fresh);
        throw;
    }
}

/// Whatever is left, one set of positions is whole: those of before the call.
template <class Cgal>
void Moving_delaunay<Cgal>::recover(std::size_t bound, Index fresh) noexcept {
    whole_ = false;
    try {
        if (filters()) filter_.restore(std::span(filter_.positions()).first(bound));
        else if (filters_each()) filter_each_.restore_bound(bound);
        else plain_.resize(bound);
        embedding_.restore(positions(), fresh);
        Move_report nobody_asked;
        if (filters()) filter_.settle(filter_.positions(), nobody_asked);
        if (filters_each()) filter_each_.settle(filter_each_.positions(), nobody_asked);
        whole_ = true;
    } catch (...) {
        embedding_.clear_cells();
    }
}

template <class Cgal>
auto Moving_delaunay<Cgal>::positions() const -> std::span<const Coordinates<d>> {
    return filters() ? filter_.positions() : filters_each() ? filter_each_.positions() : plain_;
}

/// Hands positions and triangulation to the strategy in force as given and Delaunay.
template <class Cgal>
void Moving_delaunay<Cgal>::settle_into(Move_report& report) {
    if (!filters() && !filters_each()) return;
    if (strategy_ == Strategy::automatic) return filter_.begin(plain_);
    if (!embedding_.mirrored()) embedding_.mirror();
    if (filters()) {
        filter_.settle(plain_, report);
    } else {
        filter_each_.settle(plain_, report);
    }
}

template <class Cgal>
Move_report Moving_delaunay<Cgal>::settle() {
    Move_report report;
    guarded([&] {
        if (options_.tolerance != Tolerance_kind::certified) return make_trusted(report);
        if (filters()) filter_.settle(filter_.positions(), report);
        if (filters_each()) filter_each_.settle(filter_each_.positions(), report);
    });
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
    } else if (x.data() != plain_.data()) {
        std::copy(x.begin(), x.end(), plain_.begin());
    }
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
    require_whole();
    if (vacant_.empty() && index_bound() >= Horizons::vertices)
        throw Error(Error_code::too_large, "more than " + std::to_string(Horizons::vertices) + " vertices");
    const Index i = vacant_.empty() ? static_cast<Index>(index_bound()) : vacant_.back();
    guarded([&] { insert_unguarded(i, x, report); }, i);
    if (!vacant_.empty()) vacant_.pop_back();
    if (out) *out = std::move(report);
    return embedding_.handle(i);
}

template <class Cgal>
void Moving_delaunay<Cgal>::insert_unguarded(Index i, const Coordinates<d>& x, Move_report& report) {
    make_trusted(report);
    std::vector<Index> changed;
    const int before = embedding_.dimension();
    if (!embedding_.insert(i, x, changed)) throw Error(Error_code::collision, "another vertex is at that position");
    if (!filters() && !filters_each()) {
        if (at(i) >= plain_.size()) plain_.resize(at(i) + 1);
        plain_[at(i)] = x;
    } else {
        filters() ? filter_.place(i, x) : filter_each_.place(i, x);
        if (before != d && embedding_.mirrored()) {
            report += settle();
        } else {
            filters() ? filter_.refresh(changed, report) : filter_each_.refresh(changed, report);
        }
    }
    list_changes(report, changed);
}

template <class Cgal>
void Moving_delaunay<Cgal>::remove(Vertex_handle v, Move_report* out) {
    const Index i = index(v);
    Move_report report;
    vacant_.reserve(vacant_.size() + 1);
    guarded([&] {
        make_trusted(report);
        std::vector<Index> changed;
        try {
            embedding_.remove(i, changed);
        } catch (...) {
            if (embedding_.handle(i) == Vertex_handle()) vacant_.push_back(i);  // gone, but what followed failed
            throw;
        }
        vacant_.push_back(i);
        if (filters() || filters_each()) {
            if (changed.empty()) {
                if (embedding_.mirrored()) report += settle();
            } else {
                filters() ? filter_.refresh(changed, report) : filter_each_.refresh(changed, report);
            }
        }
        list_changes(report, changed);
    });
    if (out) *out = std::move(report);
}

/// For the strategies that leave the book-keeping to CGAL: whatever may have changed, which is every finite cell.
template <class Cgal>
void Moving_delaunay<Cgal>::list_everything(Move_report& report) const {
    if (!options_.report_changes) return;
    report.changed.clear();
    embedding_.list_cells(report.changed);
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
