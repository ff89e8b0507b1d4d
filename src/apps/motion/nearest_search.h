// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/nearby_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

/// The squared distance of a point from a box.
template <class Corner>
double squared_gap(const Coordinates<3>& p, const Corner& lower, const Corner& upper) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double gap = std::max({lower[k] - p[k], p[k] - upper[k], 0.0});
        sum += gap * gap;
    }
    return sum;
}

/// The nearest point of a set of triangles, for queries that are repeated close by: the state is a ball with a list of
/// all triangles whose boxes reach into it, and a result from the list is taken when it proves that every triangle
/// outside the list is farther. O(length of the list) then; else a search of the tree, which fills the next ball.
///
/// `Tree` has `triangle(number)`, its corners t[i][k]; `project(t, p)`, its point nearest to p, however wrong where the
/// triangle is thin; `list(centre, reach, parts)`, in any order, all triangles whose boxes' `squared_gap` has a square
/// root of at most `reach`; and `nearest(p)`, approximately the nearest point of all.
///
/// The result is that of a search over all triangles: the least (distance, number), with the distance of p from the
/// projection that is rounded and moved into the triangle's box. So it is bit for bit the same, whatever the state is.
/// This needs only that no triangle's point is nearer than its box, which moving it into the box ensures, and that |p -
/// box| >= |c - box| - |p - c| for the centre c. Each of these lengths, and that of the result, is a square root of
/// three squares of differences: it errs by less than 5 u of itself, u = 2^-53, and by less than 1e-160 where squares
/// are too small to be distinguished from 0. `is_farther` leaves room for more than ten times as much.
template <class Tree>
class Nearest_search {
  public:
    /// Of parts that are kept.
    static constexpr std::size_t most_parts = 48;
    /// How far a ball reaches beyond the surface, in distances from `near`: about the number of queries that it serves.
    static constexpr double ways = 4;

    Nearest_search(const Tree& tree, Nearby_3& nearby) : tree_(tree), nearby_(nearby) {}

    /// Where p is so far away that squares overflow, `tree.nearest`.
    [[nodiscard]] Coordinates<3> nearest(const Coordinates<3>& p, const Coordinates<3>& near) {
        Best best;
        const double way = length(p, near);
        double more = ways * way;
        if (nearby_.reach > 0) {
            const double away = length(p, nearby_.centre);
            best = look(p, away);
            if (is_farther(nearby_.reach, away, best.distance())) return best.at;
            // The list had to be cut short: use a smaller ball.
            more = std::min(more, 2 * std::max(nearby_.reach - nearby_.depth, 0.01 * way));
        }
        double bound = std::min(best.distance(), way);
        while (std::isfinite(bound)) {
            fill(p, bound * (1 + 1e-12) + 1e-149 + more);
            best = look(p, 0);
            if (is_farther(nearby_.reach, 0, best.distance())) {
                nearby_.depth = best.distance();
                shorten();
                return best.at;
            }
            // `near` was not on the surface. A larger ball finds nothing farther than this, so once more is enough.
            bound = nearby_.parts.empty() ? std::max(length(p, tree_.nearest(p)), 2 * nearby_.reach) : best.distance();
        }
        nearby_ = {};
        return tree_.nearest(p);
    }

  private:
    struct Best {
        Coordinates<3> at{};
        double squared = std::numeric_limits<double>::infinity();
        std::int32_t number = 0;
        [[nodiscard]] double distance() const { return std::sqrt(squared); }
    };

    static double squared_length(const Coordinates<3>& p, const Coordinates<3>& q) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
        return sum;
    }
    static double length(const Coordinates<3>& p, const Coordinates<3>& q) { return std::sqrt(squared_length(p, q)); }

    /// Whether a part at distance `least` or more from the centre, from which p is `away`, is certainly farther than
    /// `best` from p.
    static bool is_farther(double least, double away, double best) {
        return least - away - (1e-14 * (least + away + best) + 1e-150) > best;
    }

    void fill(const Coordinates<3>& centre, double reach) {
        nearby_.reach = 0;  // until the list is whole: memory may run out
        nearby_.parts.clear();
        tree_.list(centre, reach, nearby_.parts);
        nearby_.centre = centre;
        nearby_.reach = reach;
        std::sort(nearby_.parts.begin(), nearby_.parts.end(), [](const Nearby_3::Part& a, const Nearby_3::Part& b) {
            return a.least < b.least || (a.least == b.least && a.number < b.number);
        });
    }

    void examine(std::int32_t number, const Coordinates<3>& p, Best& best) const {
        const auto& t = tree_.triangle(number);
        // By literals: an index is an int to CGAL and a size to arrays.
        const auto [x, right] = std::minmax({t[0][0], t[1][0], t[2][0]});
        const auto [y, back] = std::minmax({t[0][1], t[1][1], t[2][1]});
        const auto [z, top] = std::minmax({t[0][2], t[1][2], t[2][2]});
        const Coordinates<3> lower{x, y, z}, upper{right, back, top};
        if (squared_gap(p, lower, upper) > best.squared * (1 + 1e-14)) return;
        Coordinates<3> q = tree_.project(t, p);
        for (std::size_t k = 0; k < 3; ++k) q[k] = std::clamp(q[k], lower[k], upper[k]);
        const double squared = squared_length(p, q);
        if (squared < best.squared || (squared == best.squared && number < best.number)) best = {q, squared, number};
    }

    /// The least of the list, for a p that is `away` from its centre.
    Best look(const Coordinates<3>& p, double away) {
        Best best;
        if (nearby_.parts.empty()) return best;
        // This one is probably the nearest again; then the boxes of the others show that they are farther.
        if (nearby_.last >= 0) examine(nearby_.last, p, best);
        double distance = best.distance();
        for (const auto& part : nearby_.parts) {
            if (is_farther(part.least, away, distance)) break;
            if (part.number == nearby_.last) continue;
            examine(part.number, p, best);
            distance = best.distance();
        }
        nearby_.last = best.number;
        return best;
    }

    /// To what is worth its memory.
    void shorten() {
        auto& parts = nearby_.parts;
        if (parts.size() <= most_parts) return;
        nearby_.reach = parts[most_parts].least;
        parts.resize(most_parts);
        parts.shrink_to_fit();
    }

    const Tree& tree_;
    Nearby_3& nearby_;
};

}  // namespace annulus::inline v1
