// SPDX-License-Identifier: GPL-3.0-or-later
// What flips cannot reach: vertices taken out at the old positions and put back at the new ones.
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
Index Repair<d>::vertex_to_detach(std::span<const Index> points, std::span<const Coordinates<d>> old,
                                  std::span<const Index> movers) const {
    const auto& t = embedding_.table();
    if (movers.size() == 1) return t.corner_of(movers[0]) == none ? none : movers[0];
    // The vertex that moved farthest is the likeliest to have left its place.
    Index best = none;
    double farthest = -1.0;
    for (const Index v : points) {
        if (v < 0 || t.corner_of(v) == none) continue;
        const double moved = squared_distance<d>(x_[at(v)], old[at(v)]);
        if (moved > farthest) {
            farthest = moved;
            best = v;
        }
    }
    return best;
}

/// Takes v out at the old positions. False when it is out already, when too many are, or when the rest would be flat.
template <int d>
bool Repair<d>::take_out(Index v, std::size_t most) {
    std::vector<Index> changed;
    if (v == none || detached_.size() >= most || !embedding_.detach(v, changed)) return false;
    detached_.push_back(v);
    suspect_around(changed);
    for (const Index n : changed)
        if (!embedding_.table().is_infinite(n)) inverted_.push_back(n);
    return true;
}

/// Takes out a vertex of everything at which flips got stuck.
template <int d>
bool Repair<d>::take_out_stuck(std::span<const Coordinates<d>> old, std::span<const Index> movers, std::size_t most) {
    for (const auto& points : stuck_) {
        const auto gone = [&](Index v) { return v >= 0 && embedding_.table().corner_of(v) == none; };
        if (std::any_of(points.begin(), points.end(), gone)) continue;
        if (!take_out(vertex_to_detach(points, old, movers), most)) return false;
    }
    stuck_.clear();
    return true;
}

/// All certificates held in the end, but the border winds more than once: where cells were inverted they were unfolded the wrong
/// way. If none was, it is a ridge that should not have been flipped.
template <int d>
void Repair<d>::suspect_unfolding() {
    if constexpr (d == 3) {
        for (const auto& s : cells_)
            if (exists(s) && violated(s)) stuck_.push_back({s.point[0], s.point[1], s.point[2], s.point[3], none});
        if (!stuck_.empty()) return;
    }
    for (const auto& s : facets_)
        if (exists(s) && violated(s)) stuck_.push_back(s.point);
}

template <int d>
bool Repair<d>::reinsert(std::span<const Coordinates<d>> old, std::span<const Index> movers) {
    auto& t = embedding_.table();
    const std::size_t most = 16 + at(t.vertex_bound()) / 16;  // beyond that a rebuild is cheaper
    // In space what flips got stuck at is a small part of what is wrong, so only that is taken out to begin with.
    constexpr int rounds = d == 2 ? 1 : 8;
    constexpr int sparing = d == 2 ? 0 : 4;
    for (int round = 1;; ++round) {
        // Take out, at the old positions where CGAL's object is Delaunay: what flips got stuck at, and in the end until no
        // remaining cell is inverted at x.
        if (!take_out_stuck(old, movers, most)) return false;
        for (std::size_t i = 0; round > sparing && i < inverted_.size(); ++i) {
            const Index c = inverted_[i];
            if (!t.is_cell(c) || t.is_infinite(c) || !violated(examine_cell(c))) continue;
            const Cell_points<d> points = cell_points(t, c);
            if (!take_out(vertex_to_detach(points, old, movers), most)) return false;
        }
        inverted_.clear();
        log_.clear();
        queue_.clear();
        if (evaluate()) break;
        for (const auto& s : facets_)
            if (exists(s) && s.verdict.sign <= 0) queue_.push_back(s.id);
        for (const auto& s : cells_)
            if (exists(s) && violated(s)) inverted_.push_back(s.id);
        if (run_flips() == Progress::done) break;
        if (round == rounds) return false;
        undo_flips();
        if (stuck_.empty()) suspect_unfolding();
        if (stuck_.empty()) return false;
    }
    if (movers.empty()) {
        embedding_.set_points(x_);
    } else {
        for (const Index v : movers)
            if (t.corner_of(v) != none) embedding_.set_point(v, x_[at(v)]);
    }
    for (const Index v : detached_) {
        std::vector<Index> changed;
        if (!embedding_.attach(v, x_[at(v)], changed)) return false;
        suspect_around(changed);
    }
    queue_.clear();
    return evaluate();
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
