// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/displacement.h>
#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The way of the vertices that move.
template <int d>
struct Motion_path {
    /// The targets of all vertices, at the beginning and at the end; in between, vertices held back are elsewhere.
    std::span<Coordinates<d>> x;
    /// The sources of all vertices. Empty when a single vertex moves.
    std::span<const Coordinates<d>> source{};
    Index mover = none;  ///< the single vertex
    Coordinates<d> mover_source{};
    /// What places between source and target are rounded to multiples of: in a periodic box its grid; 0 is no rounding.
    Coordinates<d> grid{};

    [[nodiscard]] const Coordinates<d>& source_of(Index v) const {
        const auto i = static_cast<std::size_t>(v);
        return v == mover ? mover_source : source.empty() ? x[i] : source[i];
    }
};

/*
          b                     b                     b
        / | \                  /  \                  \ \
     /    |    \              /      \                \   \
    s     |  t   d           h---------d               t----d
     \    |    /              \      /                /   /
        \ | /                  \  /                  / /
          c                     c                     c

    v at its source s         v at h, half way:     next round: v advances
                              bc is flipped to vd   from h to t
*/
/// Vertices that are held back because a cell is inverted at their targets: first half way, then at their sources. In
/// the next round they advance from where they are (docs/theory.md 6.3).
///
/// In 2D, with the cells to the left of v not drawn: v moves from s to t, and its triangle with bc is inverted at t.
template <int d>
class Held_back {
  public:
    /// A vertex that is held back.
    struct Entry {
        Index vertex;
        Coordinates<d> source;  // in this round
        Coordinates<d> target;
        double fraction;  // of the way from source to target, that is tried
        int times;        // how often held back in this round
    };

    /// Starts with all vertices at their targets; their indices are below the bound.
    void begin(const Motion_path<d>& path, std::size_t bound);
    [[nodiscard]] bool empty() const { return held_.empty(); }
    [[nodiscard]] std::span<const Entry> held() const { return held_; }
    [[nodiscard]] std::span<const Coordinates<d>> positions() const { return path_.x; }
    /// Whether a single vertex moves.
    [[nodiscard]] bool is_of_one() const { return path_.mover != none; }
    /// Whether it is not at its target.
    [[nodiscard]] bool is_waiting(const Entry& held) const { return path_.x[at(held.vertex)] != held.target; }
    /// Whether a vertex got nearer to its target in this round.
    [[nodiscard]] bool has_advanced() const {
        return std::any_of(held_.begin(), held_.end(),
                           [this](const Entry& h) { return path_.x[at(h.vertex)] != h.source; });
    }

    /// Moves one of these vertices back, the one farthest from its source: half way the first time, to its source the
    /// next time. Returns it, or `none` when none can be moved back: all are at their sources or, after the first
    /// round, not held back.
    [[nodiscard]] Index hold_back(const Cell_sites<d>& cell);
    /// Begins a round: every vertex that is not at its target advances towards it; moved(v) is called after each.
    /// Returns whether a vertex got nearer to its target in the last round.
    template <class Moved>
    [[nodiscard]] bool advance(Moved moved);
    /// Calls place(x, v, target) for each that is not at its target, until this returns false, and returns whether none
    /// did. x are the positions, which it changes.
    template <class Place>
    [[nodiscard]] bool place(Place place);
    /// Puts all vertices at their targets; moved(v) is called after each that was elsewhere.
    template <class Moved>
    void release(Moved moved);

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    /// The place that this vertex is tried at.
    [[nodiscard]] Coordinates<d> on_the_way(const Entry& held) const {
        Coordinates<d> p = held.source;
        for (std::size_t i = 0; i < p.size(); ++i) {
            p[i] += held.fraction * (held.target[i] - held.source[i]);
            if (path_.grid[i] != 0.0) p[i] = std::nearbyint(p[i] / path_.grid[i]) * path_.grid[i];
        }
        return p;
    }

    Motion_path<d> path_;
    bool first_round_ = true;
    std::vector<Entry> held_;
    std::vector<Index> place_of_;  // by vertex: 1 + its place in held_, 0 when it is not held back
};

template <int d>
void Held_back<d>::begin(const Motion_path<d>& path, std::size_t bound) {
    path_ = path;
    first_round_ = true;
    place_of_.resize(bound, 0);
}

template <int d>
Index Held_back<d>::hold_back(const Cell_sites<d>& cell) {
    Index farthest = none;
    double most = 0.0;
    for (const auto& [v, label] : cell) {
        if (v == infinite) continue;
        const Index k = place_of_[at(v)];
        if (k == 0 && !first_round_) continue;  // the others have been flipped for its present position
        const Coordinates<d>& source = k != 0 ? held_[at(k - 1)].source : path_.source_of(v);
        const double way = squared_distance<d>(path_.x[at(v)], source);  // may underflow
        if (way > most || (farthest == none && path_.x[at(v)] != source)) {
            most = way;
            farthest = v;
        }
    }
    if (farthest == none) return none;
    Index& k = place_of_[at(farthest)];
    Coordinates<d>& x = path_.x[at(farthest)];
    if (k == 0) {
        held_.push_back({farthest, path_.source_of(farthest), x, 1.0, 0});
        k = static_cast<Index>(held_.size());
    }
    Entry& held = held_[at(k - 1)];
    held.fraction *= 0.5;
    if (++held.times > 1) {
        x = held.source;
        return farthest;
    }
    const Coordinates<d> p = on_the_way(held);
    x = p == x ? held.source : p;
    return farthest;
}

template <int d>
template <class Moved>
bool Held_back<d>::advance(Moved moved) {
    bool progress = false;
    std::size_t left = 0;
    first_round_ = false;
    for (Entry held : held_) {
        const Coordinates<d>& here = path_.x[at(held.vertex)];
        if (here != held.source) {
            progress = true;
            held.fraction = 1.0;
        }
        place_of_[at(held.vertex)] = 0;
        if (here == held.target) continue;
        held.source = here;
        held.times = 0;
        held_[left++] = held;
        place_of_[at(held.vertex)] = static_cast<Index>(left);
    }
    held_.resize(left);
    for (const Entry& held : held_) {
        path_.x[at(held.vertex)] = held.fraction < 1.0 ? on_the_way(held) : held.target;
        moved(held.vertex);
    }
    return progress;
}

template <int d>
template <class Place>
bool Held_back<d>::place(Place place) {
    for (const Entry& held : held_)
        if (is_waiting(held) && !place(path_.x, held.vertex, held.target)) return false;
    return true;
}

template <int d>
template <class Moved>
void Held_back<d>::release(Moved moved) {
    for (const Entry& held : held_) {
        place_of_[at(held.vertex)] = 0;
        if (path_.x[at(held.vertex)] == held.target) continue;
        path_.x[at(held.vertex)] = held.target;
        moved(held.vertex);
    }
    held_.clear();
}

}  // namespace annulus::inline v1
