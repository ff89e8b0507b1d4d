// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/relocation/repair.h>

#include <annulus/arithmetic/error.h>
#include <annulus/relocation/displacement.h>

#include <algorithm>
#include <bit>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

template <int d>
void Repair<d>::begin(std::span<const Coordinates<d>> x, bool many) {
    many_ = many;
    everything_ = false;
    forget();
    x_ = x;
    const auto& t = embedding_.table();
    place_of_facet_.resize(at(t.facet_bound()), 0);
    place_of_cell_.resize(at(t.cell_bound()), 0);
    disturbed_.clear();
    detached_.clear();
    changed_.clear();
    rebuilt_ = false;
    log_.clear();
    report_ = {};
}

template <int d>
void Repair<d>::forget() {
    for (const auto& s : facets_) place_of_facet_[at(s.id)] = 0;
    for (const auto& s : cells_) place_of_cell_[at(s.id)] = 0;
    facets_.clear();
    cells_.clear();
}

template <int d>
void Repair<d>::suspect_facet(Index f, Facet_kind kind, const Facet_points<d>& points) {
    if (at(f) >= place_of_facet_.size()) place_of_facet_.resize(at(f) + 1, 0);
    Index& place = place_of_facet_[at(f)];
    if (place == 0) {
        facets_.push_back({});
        place = static_cast<Index>(facets_.size());
    }
    Facet_suspect& s = facets_[at(place - 1)];
    s.id = f;
    s.point = points;
    s.kind = kind;
    s.stale = true;
}

/// Facet f with its kind and points, to be examined.
template <int d>
typename Repair<d>::Facet_suspect Repair<d>::facet_suspect(Index f) const {
    const auto& t = embedding_.table();
    const Index h = t.half(f);
    Facet_suspect s;
    s.id = f;
    s.kind = facet_kind(t, h);
    s.point.fill(none);
    if (s.kind == Facet_kind::empty_sphere) {
        s.point = bicell_points(t, h);
    } else if (s.kind == Facet_kind::ridge) {
        const Cell_points<d> ridge = ridge_vertex_last(t, h, ridge_points(t, h));
        std::copy(ridge.begin(), ridge.end(), s.point.begin());
    } else if (kind_ == Tolerance_kind::paper) {
        const Cell_points<d> slab = slab_points(t, h);
        std::copy(slab.begin(), slab.end(), s.point.begin());
        s.kind = Facet_kind::slab;
    }
    return s;
}

template <int d>
typename Repair<d>::Cell_suspect Repair<d>::cell_suspect(Index c) const {
    const auto& t = embedding_.table();
    Cell_suspect s;
    s.id = c;
    s.kind = t.is_infinite(c) ? Facet_kind::border : Facet_kind::empty_sphere;
    s.point = cell_points(t, c);
    return s;
}

template <int d>
void Repair<d>::suspect_facet(Index f) {
    const Facet_suspect s = facet_suspect(f);
    suspect_facet(f, s.kind, s.point);
}

template <int d>
void Repair<d>::suspect_everything() {
    const auto& t = embedding_.table();
    for (Index f = 0; f < t.facet_bound(); ++f)
        if (t.is_facet(f)) suspect_facet(f);
    for (Index c = 0; c < t.cell_bound(); ++c)
        if (t.is_cell(c)) suspect_cell(c);
}

template <int d>
void Repair<d>::suspect_star(Index v) {
    const auto& t = embedding_.table();
    t.for_each_corner(v, [&](Index h) {
        suspect_cell(t.cell_of(h));
        suspect_facet(t.facet(h));
        suspect_facet(t.facet(t.ccw(h)));
    });
}

template <int d>
void Repair<d>::suspect_cell(Index c) {
    if (at(c) >= place_of_cell_.size()) place_of_cell_.resize(at(c) + 1, 0);
    Index& place = place_of_cell_[at(c)];
    if (place == 0) {
        cells_.push_back({});
        place = static_cast<Index>(cells_.size());
    }
    cells_[at(place - 1)] = cell_suspect(c);
}

template <int d>
void Repair<d>::suspect_cells(std::span<const Index> cells) {
    const auto& t = embedding_.table();
    for (const Index c : cells) {
        suspect_cell(c);
        for (int i = 0; i <= d; ++i) suspect_facet(t.facet(t.corner(c, i)));
    }
}

template <int d>
void Repair<d>::suspect_around(std::span<const Index> cells) {
    const auto& t = embedding_.table();
    changed_.insert(changed_.end(), cells.begin(), cells.end());
    suspect_cells(cells);
    for (const Index c : cells)
        for (int i = 0; i <= d; ++i) queue_.push_back(t.facet(t.corner(c, i)));
}

template <int d>
void Repair<d>::list_changes(Move_report& report) const {
    const auto& t = embedding_.table();
    const auto list = [&](Index c) {
        if (!t.is_cell(c)) return;
        for (int i = 0; i <= d; ++i) report.changed.push_back(t.vertex(t.corner(c, i)));
    };
    if (rebuilt_) {
        for (Index c = 0; c < t.cell_bound(); ++c) list(c);
    } else {
        for (const Index c : changed_) list(c);
    }
}

template <int d>
void Repair<d>::collect_violated() {
    queue_.clear();
    inverted_.clear();
    for (const auto& s : cells_) {
        if (!exists(s) || !violated(s)) continue;
        inverted_.push_back(s.id);
        disturbed_.insert(disturbed_.end(), s.point.begin(), s.point.end());
    }
    for (const auto& s : facets_) {
        if (!exists(s) || s.verdict.sign > 0) continue;
        queue_.push_back(s.id);
        if (s.kind == Facet_kind::empty_sphere && s.verdict.sign == 0) continue;  // degenerate, not violated yet
        for (const Index v : s.point)
            if (v != none) disturbed_.push_back(v);
    }
}

template <int d>
void Repair<d>::flip(Index h) {
    auto& t = embedding_.table();
    log_.emplace_back(t.cell_of(h), t.cell_of(t.twin(h)));
    embedding_.flip(h);
    ++report_.flips;
}

template <int d>
typename Repair<d>::Outcome Repair<d>::mend(std::span<const Coordinates<d>> old, std::span<const Index> movers) {
    collect_violated();
    if (run_flips() == Progress::done) return Outcome::flipped;
    undo_flips();
    require_distinct(movers);
    // Without certified tolerances the triangulation may be wrong in places nobody suspects; CGAL's removal and
    // location need a right one, a rebuild does not.
    if (trusted_ && reinsert(old, movers)) return Outcome::reinserted;
    forget();
    detached_.clear();
    embedding_.rebuild(x_);
    rebuilt_ = true;
    return Outcome::rebuilt;
}

template <int d>
void Repair<d>::require_distinct(std::span<const Index> movers) const {
    const auto& t = embedding_.table();
    const auto collide = [] { throw Error(Error_code::collision, "two vertices would share a position"); };
    if (movers.size() == 1) {
        const Coordinates<d>& p = x_[at(movers[0])];
        for (Index v = 0; v < t.vertex_bound(); ++v)
            if (v != movers[0] && t.corner_of(v) != none && x_[at(v)] == p) collide();
        return;
    }
    // Those that share a bit of a hash with another vertex, a few in a hundred, are sorted.
    const std::size_t bits = std::bit_ceil(32 * at(t.vertex_bound()) + 1);
    std::vector<bool> met(bits);
    std::vector<bool> met_again(bits);
    const auto bit_of = [&](Index v) {
        std::uint64_t hash = 0;
        for (const double c : x_[at(v)]) {
            const auto word = std::bit_cast<std::uint64_t>(c + 0.0);  // -0 and 0 are one place
            hash = (hash ^ word ^ (word >> 32)) * 0x9E3779B97F4A7C15;
            hash ^= hash >> 32;
        }
        return static_cast<std::size_t>(hash) & (bits - 1);
    };
    for (Index v = 0; v < t.vertex_bound(); ++v) {
        if (t.corner_of(v) == none) continue;
        const std::size_t bit = bit_of(v);
        (met[bit] ? met_again : met)[bit] = true;
    }
    std::vector<Index> order;
    for (Index v = 0; v < t.vertex_bound(); ++v)
        if (t.corner_of(v) != none && met_again[bit_of(v)]) order.push_back(v);
    std::sort(order.begin(), order.end(), [this](Index l, Index r) { return x_[at(l)] < x_[at(r)]; });
    for (std::size_t i = 1; i < order.size(); ++i)
        if (x_[at(order[i - 1])] == x_[at(order[i])]) collide();
}

template <int d>
Index Repair<d>::vertex_to_detach(Index c, std::span<const Coordinates<d>> old,
                                 std::span<const Index> movers) const {
    const auto& t = embedding_.table();
    if (movers.size() == 1) return t.corner_of(movers[0]) == none ? none : movers[0];
    // The vertex that moved farthest is the likeliest to have left its place.
    Index best = none;
    double farthest = -1.0;
    for (const Index v : cell_points(t, c)) {
        if (v == infinite) continue;
        const double moved = squared_distance<d>(x_[at(v)], old[at(v)]);
        if (moved > farthest) {
            farthest = moved;
            best = v;
        }
    }
    return best;
}

template <int d>
bool Repair<d>::reinsert(std::span<const Coordinates<d>> old, std::span<const Index> movers) {
    auto& t = embedding_.table();
    const std::size_t most = 16 + at(t.vertex_bound()) / 16;  // beyond that a rebuild is cheaper
    std::vector<Index> changed;
    // Take out, at the old positions where CGAL's object is Delaunay, until no remaining cell is inverted at x.
    for (std::size_t i = 0; i < inverted_.size(); ++i) {
        const Index c = inverted_[i];
        if (!t.is_cell(c) || !violated(examine_cell(c))) continue;
        if (detached_.size() >= most) return false;
        const Index v = vertex_to_detach(c, old, movers);
        changed.clear();
        if (v == none || !embedding_.detach(v, changed)) return false;
        detached_.push_back(v);
        suspect_around(changed);
        for (const Index n : changed)
            if (!t.is_infinite(n)) inverted_.push_back(n);
    }
    inverted_.clear();
    if (!evaluate()) {
        for (const auto& s : facets_)
            if (exists(s) && s.verdict.sign <= 0) queue_.push_back(s.id);
        if (run_flips() == Progress::stuck) return false;
    }
    if (movers.empty()) {
        embedding_.set_points(x_);
    } else {
        for (const Index v : movers)
            if (t.corner_of(v) != none) embedding_.set_point(v, x_[at(v)]);
    }
    for (const Index v : detached_) {
        changed.clear();
        if (!embedding_.attach(v, x_[at(v)], changed)) return false;
        suspect_around(changed);
    }
    queue_.clear();
    return evaluate();
}

template <int d>
void Repair<d>::undo_flips() {
    report_.undone_flips += log_.size();
    report_.flips -= log_.size();
    for (; !log_.empty(); log_.pop_back()) {
        const auto [c, n] = log_.back();
        undo_flip(c, n);
    }
    // What is under examination has other points again.
    std::vector<Index> again;
    for (const auto& s : cells_) again.push_back(s.id);
    for (const Index c : again) suspect_cell(c);
    again.clear();
    for (const auto& s : facets_) again.push_back(s.id);
    for (const Index f : again) suspect_facet(f);
    (void)evaluate();
    const std::size_t known = disturbed_.size();
    collect_violated();
    disturbed_.resize(known);
}

template class Repair<2>;

}  // namespace annulus
