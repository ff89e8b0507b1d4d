// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/motion/feature_curves.h>
#include <apps/motion/vectors_3.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Sharp_edge = std::array<Index, 2>;

std::size_t place_of(Index i) { return static_cast<std::size_t>(i); }

/// An angle in [0, pi] between vectors of any length but 0.
double angle_between(const Coordinates<3>& u, const Coordinates<3>& v) {
    const Coordinates<3> n = cross(u, v);
    return std::atan2(std::hypot(n[0], n[1], n[2]), dot(u, v));
}

Coordinates<3> direction(const Coordinates<3>& p, const Coordinates<3>& q) {
    const Coordinates<3> d = minus(q, p);
    const double length = std::hypot(d[0], d[1], d[2]);
    return {d[0] / length, d[1] / length, d[2] / length};
}

/// Normals from unit vectors, so that those of small triangles do not underflow.
Coordinates<3> normal_of(const Triangle_surface& s, const std::array<Index, 3>& t) {
    const auto p = [&](std::size_t i) { return s.points[place_of(t[i])]; };
    return cross(direction(p(0), p(1)), direction(p(0), p(2)));
}

/// Sorted, the lesser end first.
std::vector<Sharp_edge> sharp_edges(const Triangle_surface& s, double angle) {
    struct Side {
        Sharp_edge ends;
        std::size_t triangle;
    };
    std::vector<Side> sides;
    for (std::size_t t = 0; t < s.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Index a = s.triangles[t][i], b = s.triangles[t][(i + 1) % 3];
            sides.push_back({{std::min(a, b), std::max(a, b)}, t});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return x.ends != y.ends ? x.ends < y.ends : x.triangle < y.triangle;
    });
    std::vector<Sharp_edge> sharp;
    for (std::size_t i = 1; i < sides.size(); ++i)
        if (sides[i].ends == sides[i - 1].ends && angle_between(normal_of(s, s.triangles[sides[i - 1].triangle]),
                                                                normal_of(s, s.triangles[sides[i].triangle])) > angle)
            sharp.push_back(sides[i].ends);
    return sharp;
}

/// The edges around each vertex of a graph, and which have been walked.
class Edge_walk {
  public:
    Edge_walk(const std::vector<Sharp_edge>& edges, std::size_t n) : begin_(n + 2, 0), half_(2 * edges.size()) {
        for (const Sharp_edge& e : edges)
            for (const Index v : e) ++begin_[place_of(v) + 2];
        for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
        for (const Sharp_edge& e : edges)
            for (const std::size_t i : {std::size_t{0}, std::size_t{1}})
                half_[begin_[place_of(e[i]) + 1]++] = {e[1 - i], false};
    }
    [[nodiscard]] std::size_t degree(Index v) const { return begin_[place_of(v) + 1] - begin_[place_of(v)]; }
    [[nodiscard]] Index other(Index v, std::size_t i) const { return half_[begin_[place_of(v)] + i].to; }

    /// Continues from v along the first edge that has not been walked; returns none where all have been.
    Index next(Index v) {
        for (std::size_t i = begin_[place_of(v)]; i < begin_[place_of(v) + 1]; ++i) {
            if (half_[i].walked) continue;
            half_[i].walked = true;
            const Index to = half_[i].to;
            for (std::size_t j = begin_[place_of(to)]; j < begin_[place_of(to) + 1]; ++j)
                if (half_[j].to == v) half_[j].walked = true;
            return to;
        }
        return none;
    }

  private:
    struct Half {
        Index to;
        bool walked;
    };
    std::vector<std::size_t> begin_;
    std::vector<Half> half_;
};

}  // namespace

Feature_curves::Feature_curves(const Triangle_surface& s, double degrees) {
    if (!(degrees > 0 && degrees < 180))
        throw Error(Error_code::usage, "the angle of sharp edges must be between 0 and 180 degrees");
    const double angle = degrees * std::numbers::pi / 180;
    const std::vector<Sharp_edge> edges = sharp_edges(s, angle);
    const auto n = static_cast<Index>(s.points.size());
    Edge_walk walk(edges, s.points.size());
    const auto point = [&s](Index v) { return s.points[place_of(v)]; };
    std::vector<char> corner(s.points.size(), 0);
    for (Index v = 0; v < n; ++v) {
        if (walk.degree(v) == 0) continue;
        if (walk.degree(v) == 2 && angle_between(direction(point(walk.other(v, 0)), point(v)),
                                                 direction(point(v), point(walk.other(v, 1)))) <= angle)
            continue;
        corner[place_of(v)] = 1;
        corners_.push_back(point(v));
    }
    const auto follow = [&](Index from) {
        for (Index v = walk.next(from); v != none; v = walk.next(from)) {
            std::vector<Coordinates<3>> points{point(from), point(v)};
            while (v != from && corner[place_of(v)] == 0) points.push_back(point(v = walk.next(v)));
            curves_.emplace_back(std::move(points));
        }
    };
    for (Index v = 0; v < n; ++v)
        if (corner[place_of(v)] != 0) follow(v);
    between_corners_ = curves_.size();
    for (Index v = 0; v < n; ++v) follow(v);  // what is left goes around
}

std::vector<Feature_curves::Place> Feature_curves::places(std::span<const Coordinates<3>> points, double reach) const {
    std::vector<Place> place(points.size(), Place::off);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return points[i] < points[j]; });
    const auto for_each_near = [&](const Coordinates<3>& lower, const Coordinates<3>& upper, const auto& visit) {
        auto at = std::lower_bound(order.begin(), order.end(), lower[0] - reach,
                                   [&](std::size_t i, double x) { return points[i][0] < x; });
        for (; at != order.end() && points[*at][0] <= upper[0] + reach; ++at) {
            const Coordinates<3>& p = points[*at];
            const bool near = p[1] >= lower[1] - reach && p[1] <= upper[1] + reach && p[2] >= lower[2] - reach &&
                              p[2] <= upper[2] + reach;
            if (near && place[*at] == Place::off) visit(*at);
        }
    };
    for (const Coordinates<3>& c : corners_)
        for_each_near(c, c, [&](std::size_t i) {
            if (distance(points[i], c) <= reach) place[i] = Place::corner;
        });
    for (std::size_t c = 0; c < curves_.size(); ++c)
        for_each_near(curves_[c].lower(), curves_[c].upper(), [&](std::size_t i) {
            if (distance(points[i], curves_[c].at(curves_[c].nearest(points[i]))) <= reach)
                place[i] = static_cast<Place>(c);
        });
    return place;
}

void Feature_curves::snap(std::span<Coordinates<3>> points, double reach) const {
    const std::vector<Place> place = places(points, reach);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const auto c = static_cast<Index>(place[i]); c >= 0) {
            const Polyline_3& curve = curves_[place_of(c)];
            points[i] = curve.at(curve.nearest(points[i]));
        }
}

}  // namespace annulus::inline v1
