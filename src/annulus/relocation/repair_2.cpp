// SPDX-License-Identifier: GPL-3.0-or-later
// Flips in the plane. A triangulation of the sphere S + infinity whose finite triangles are all positive is brought to
// the Delaunay triangulation by Lawson flips (infinity included: flipping a reflex hull vertex fills a pocket); a
// triangle that is inverted at the new positions is first unfolded by flips that leave fewer inverted ones.
#include <annulus/relocation/repair.h>

#include <algorithm>

namespace annulus {

namespace {
std::size_t at(Index i) { return static_cast<std::size_t>(i); }
}  // namespace

/// The other diagonal must not be an edge already, else the flip would double it.
template <>
bool Repair<2>::flip_is_simplicial(Index h) const {
    const auto& t = embedding_.table();
    Index p = t.vertex(h);
    Index q = t.vertex(t.twin(h));
    if (p == q) return false;
    if (p == infinite) std::swap(p, q);
    bool adjacent = false;
    t.for_each_corner(p, [&](Index k) { adjacent = adjacent || t.vertex(t.ccw(k)) == q; });
    return !adjacent;
}

/// Flips one edge of the inverted triangle c so that fewer triangles are inverted. False when no edge does that.
template <>
bool Repair<2>::unfold(Index c) {
    const auto& t = embedding_.table();
    const auto holds = [&](Index u, Index v, Index w) {
        if (u == infinite || v == infinite || w == infinite) return true;
        return orientation_verdict({&x_[at(u)], &x_[at(v)], &x_[at(w)]}, false).sign > 0;
    };
    for (int i = 0; i <= 2; ++i) {
        const Index h = t.corner(c, i);
        const Index n = t.cell_of(t.twin(h));
        const Index p = t.vertex(h);
        const Index q = t.vertex(t.twin(h));
        const Index a = t.vertex(t.ccw(h));
        const Index b = t.vertex(t.cw(h));
        const int before = 1 + (!t.is_infinite(n) && violated(examine_cell(n)) ? 1 : 0);
        const int after = (holds(p, a, q) ? 0 : 1) + (holds(q, b, p) ? 0 : 1);
        if (after >= before || !flip_is_simplicial(h)) continue;
        flip(h);
        many_ = true;
        const std::array<Index, 2> both{c, n};
        suspect_around(both);
        for (const Index k : both)
            if (violated(examine_cell(k))) inverted_.push_back(k);
        return true;
    }
    return false;
}

/// Around infinity the border is walked clockwise. It turns right everywhere, so it winds as often as its direction
/// enters the half-plane of directions that point up, or right when level.
template <>
bool Repair<2>::border_winds_once() const {
    const auto& t = embedding_.table();
    const Index first = t.corner_of_infinity();
    const auto points_up = [&](Index h) {
        const Coordinates<2>& from = x_[at(t.vertex(t.ccw(h)))];
        const Coordinates<2>& to = x_[at(t.vertex(t.cw(h)))];
        return from[1] < to[1] || (from[1] == to[1] && from[0] < to[0]);
    };
    int entries = 0;
    bool before = points_up(first);
    Index h = first;
    do {
        h = t.next_around(h);
        const bool now = points_up(h);
        if (now && !before) ++entries;
        before = now;
    } while (h != first);
    return entries == 1;
}

/// Four flips of a quadrilateral's diagonal give the same two triangles with their corners turned by one place, twelve
/// are the identity; so eleven undo one, and records kept by corner stay valid.
template <>
void Repair<2>::take_back_flips() {
    const auto& t = embedding_.table();
    for (; !log_.empty(); log_.pop_back()) {
        const auto [c, n] = log_.back();
        for (int turn = 0; turn < 11; ++turn) {
            Index h = t.corner(c, 0);
            while (t.cell_of(t.twin(h)) != n) h = t.ccw(h);
            embedding_.flip(h);
        }
    }
}

template <>
void Repair<2>::flip(Index h) {
    const auto& t = embedding_.table();
    log_.push_back({t.cell_of(h), t.cell_of(t.twin(h))});
    embedding_.flip(h);
    ++report_.flips;
}

template <>
Repair<2>::Progress Repair<2>::run_flips() {
    const auto& t = embedding_.table();
    // A vertex that left its star crosses a few triangles; more than this and reinsertion is cheaper.
    std::size_t budget = 16 + 8 * inverted_.size();
    while (!inverted_.empty()) {
        const Index c = inverted_.back();
        inverted_.pop_back();
        if (!violated(examine_cell(c))) continue;
        if (budget-- == 0 || !unfold(c)) return Progress::stuck;
    }
    budget = 1000 + 64 * queue_.size();
    while (!queue_.empty()) {
        const Index f = queue_.back();
        queue_.pop_back();
        if (!t.is_facet(f)) continue;
        if (!violated(examine_facet(f))) continue;
        const Index h = t.half(f);
        if (budget-- == 0 || !flip_is_simplicial(h)) return Progress::stuck;
        const std::array<Index, 2> both{t.cell_of(h), t.cell_of(t.twin(h))};
        flip(h);
        suspect_around(both);
        // In a valid triangulation a violated edge is flippable; if not, there is more wrong than flips can mend.
        for (const Index k : both)
            if (violated(examine_cell(k))) return Progress::stuck;
    }
    return evaluate() ? Progress::done : Progress::stuck;
}

}  // namespace annulus
