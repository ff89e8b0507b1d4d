// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/convex_ring_2.h>

#include <annulus/predicate/exact_sign.h>
#include <apps/motion/ring_corners_2.h>
#include <apps/motion/vector_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <string>

namespace annulus::inline v1 {

namespace {

using Listed = Listed_corner;
using Ring = std::vector<Listed>;

[[noreturn]] void fail(std::size_t corner, const std::string& what) {
    throw Corner_error(corner, what + " at corner " + std::to_string(corner) + ", counted from 0");
}

int turn(const Listed& a, const Listed& b, const Listed& c) { return exact_orientation_sign({&a.p, &b.p, &c.p}).sign; }

/// A bound of the rounding of coordinates up to `scale`, and of distances computed from them.
double slack_at(double scale) { return 4e-15 * scale; }

/// Exact: a corner on the line of its neighbours is between them and is dropped, or the list turns back at it.
Ring without_flat_corners(const Ring& ring) {
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Listed& a = ring[i > 0 ? i - 1 : ring.size() - 1];
        const Listed& b = ring[i];
        const Listed& c = ring[i + 1 < ring.size() ? i + 1 : 0];
        if (turn(a, b, c) != 0) kept.push_back(b);
        else if ((a.p < b.p) != (b.p < c.p)) fail(b.index, "a polygon must not go back on itself, as it does");
    }
    return kept;
}

/// The corners dropped between hull corners a and b must be on the edge, up to rounding, one after another.
void require_edge(const Listed& a, const Listed& b, std::span<const Listed> between, bool reversed, double scale) {
    const Coordinates<2> d = minus(b.p, a.p);
    const double length = norm(d), slack = slack_at(scale);
    double farthest = 0, reached = 0;
    const Listed* worst = nullptr;
    for (const Listed& c : between) {
        const Coordinates<2> way = minus(c.p, a.p);
        const double depth = std::abs(cross(d, way)) / length, along = dot(d, way) / length;
        if (depth > std::max(farthest, slack)) {
            farthest = depth;
            worst = &c;
        } else if (worst == nullptr && !(along >= reached - 2 * slack && along <= length + 2 * slack)) {
            fail(c.index, "a polygon must not go back on itself, as it does");
        }
        reached = std::max(reached, along);
    }
    if (worst == nullptr) return;
    // A pocket has a corner at which the list turns the other way; that one is examined.
    for (std::size_t k = 0; k < between.size(); ++k)
        if (turn(k > 0 ? between[k - 1] : a, between[k], k + 1 < between.size() ? between[k + 1] : b) < 0) {
            worst = &between[k];
            break;
        }
    fail(worst->index, reversed ? "a polygon must be convex; this one goes around clockwise and turns left"
                                : "a polygon must be convex; this one goes around counter-clockwise and turns right");
}

/// Graham's scan of a list that is in order already: what it drops is not a corner of the convex hull.
Ring hull_of(const Ring& ring, bool reversed, double scale) {
    std::vector<std::size_t> hull{0};
    const auto drop_back_at = [&](const Listed& next) {
        while (hull.size() > 1 && turn(ring[hull[hull.size() - 2]], ring[hull.back()], next) <= 0) hull.pop_back();
    };
    for (std::size_t i = 1; i < ring.size(); ++i) {
        drop_back_at(ring[i]);
        hull.push_back(i);
    }
    drop_back_at(ring[0]);
    Ring kept;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const std::size_t from = hull[k] + 1, to = k + 1 < hull.size() ? hull[k + 1] : ring.size();
        require_edge(ring[hull[k]], ring[k + 1 < hull.size() ? hull[k + 1] : 0],
                     std::span(ring).subspan(from, to - from), reversed, scale);
        kept.push_back(ring[hull[k]]);
    }
    if (kept.size() < 3 || turn(kept.back(), kept[0], kept[1]) <= 0)
        fail(kept[0].index, "a polygon must go around once; this one crosses itself");
    return kept;
}

/// Corners that rounding has moved off a line span a triangle or two, and nothing else.
void require_width(const Ring& ring, double scale) {
    double length = 0, width = 0;
    Coordinates<2> from{}, along{};
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Coordinates<2> d = minus(ring[i + 1 < ring.size() ? i + 1 : 0].p, ring[i].p);
        if (norm(d) <= length) continue;
        length = norm(d);
        from = ring[i].p;
        along = d;
    }
    for (const Listed& c : ring) width = std::max(width, std::abs(cross(along, minus(c.p, from))) / length);
    if (width <= slack_at(scale) && width <= 1e-10 * length)
        throw Corner_error(0, "a polygon needs 3 corners that are not on a line; up to rounding these are on one line");
}

/// Corners that all turn left go around as often as their direction comes from the lower half of all directions to
/// the upper.
void require_one_round(const Ring& ring) {
    const auto rises = [&](std::size_t i) {
        const Coordinates<2>& a = ring[i % ring.size()].p;
        const Coordinates<2>& b = ring[(i + 1) % ring.size()].p;
        return b[1] > a[1] || (b[1] == a[1] && b[0] > a[0]);
    };
    std::size_t rounds = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (!rises(i) && rises(i + 1) && ++rounds > 1)
            fail(ring[(i + 1) % ring.size()].index, "a polygon must go around once; this one begins another round");
}

}  // namespace

std::vector<Coordinates<2>> convex_ring(std::span<const Coordinates<2>> corners) {
    const double scale = largest_coordinate(corners);
    Ring ring = without_flat_corners(ring_corners(corners));
    const auto smaller = [](const Listed& a, const Listed& b) { return a.p < b.p; };
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end(), smaller), ring.end());
    // The smallest corner is one of the hull, so the list turns there as it does everywhere.
    const bool reversed = turn(ring.back(), ring[0], ring[1]) < 0;
    if (reversed) std::reverse(std::next(ring.begin()), ring.end());
    ring = hull_of(ring, reversed, scale);
    require_one_round(ring);
    require_width(ring, scale);
    std::vector<Coordinates<2>> kept;
    for (const Listed& c : ring) kept.push_back(c.p);
    return kept;
}

}  // namespace annulus::inline v1
