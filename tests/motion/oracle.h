// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/density_2.h>
#include <apps/motion/moments_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

/// Slow and simple reference results: 80-bit arithmetic, brute force, nothing shared with the library.
namespace oracle {

using annulus::Coordinates;
using annulus::Density;
using Real = long double;
static_assert(sizeof(Real) > sizeof(double), "the oracle needs extended precision");

struct Point {
    Real x, y;
};

struct Moments {
    Real mass = 0, x = 0, y = 0, second = 0;
};

inline Real density(Density kind, Real x, Real y) {
    switch (kind) {
        case Density::one: return 1;
        case Density::x2_plus_y2: return x * x + y * y;
        case Density::x2: return x * x;
        case Density::sin2: return std::pow(std::sin(std::hypot(x, y)), 2);
    }
    return 0;
}

/// Five-point Gauss-Legendre on [0, 1], from its closed form.
inline const std::vector<Point>& gauss5() {
    static const std::vector<Point> rule = [] {
        const Real s = std::sqrt(Real(70)), near = std::sqrt(5 - 2 * std::sqrt(Real(10) / 7)) / 3,
                   far = std::sqrt(5 + 2 * std::sqrt(Real(10) / 7)) / 3;
        const Real wn = (322 + 13 * s) / 1800, wf = (322 - 13 * s) / 1800;
        return std::vector<Point>{{(1 - far) / 2, wf},
                                  {(1 - near) / 2, wn},
                                  {Real(0.5), Real(128) / 450},
                                  {(1 + near) / 2, wn},
                                  {(1 + far) / 2, wf}};
    }();
    return rule;
}

/// Adds the moments about c of the triangle c + (p, q, r), cut into quarters until its sides are at most `size`.
/// `density` is a function of x and y.
template <class At>
void add_triangle(Moments& sum, const At& density, Point c, Point p, Point q, Point r, Real size) {
    const auto side = [](Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); };
    if (std::max({side(p, q), side(q, r), side(r, p)}) > size) {
        const auto mid = [](Point a, Point b) { return Point{(a.x + b.x) / 2, (a.y + b.y) / 2}; };
        const Point pq = mid(p, q), qr = mid(q, r), rp = mid(r, p);
        add_triangle(sum, density, c, p, pq, rp, size);
        add_triangle(sum, density, c, q, qr, pq, size);
        add_triangle(sum, density, c, r, rp, qr, size);
        add_triangle(sum, density, c, pq, qr, rp, size);
        return;
    }
    const Real twice = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    for (const Point s : gauss5())
        for (const Point t : gauss5()) {
            // p + s (q - p) + s t (r - q), Jacobian s
            const Real x = p.x + s.x * (q.x - p.x) + s.x * t.x * (r.x - q.x);
            const Real y = p.y + s.x * (q.y - p.y) + s.x * t.x * (r.y - q.y);
            const Real w = twice * s.x * s.y * t.y * density(c.x + x, c.y + y);
            sum.mass += w, sum.x += w * x, sum.y += w * y, sum.second += w * (x * x + y * y);
        }
}

/// Moments about c of a convex straight-edged polygon given by offsets from c.
inline Moments polygon(Density kind, Coordinates<2> c, const std::vector<Coordinates<2>>& offset, Real size) {
    Moments sum;
    const auto point = [](Coordinates<2> p) { return Point{p[0], p[1]}; };
    for (std::size_t i = 1; i + 1 < offset.size(); ++i)
        add_triangle(
            sum, [kind](Real x, Real y) { return density(kind, x, y); }, point(c), point(offset[0]), point(offset[i]),
            point(offset[i + 1]), size);
    return sum;
}

/// A random convex polygon around the origin of offsets: corners on a circle at sorted angles, squeezed in one
/// direction; radius is its greatest extent.
template <class Random>
std::vector<Coordinates<2>> random_polygon(Random& random, double radius) {
    std::uniform_real_distribution<double> unit(0, 1);
    const int n = 3 + static_cast<int>(random() % 6);
    const double turn = 6.28 * unit(random), squeeze = 0.3 + 0.7 * unit(random);
    std::vector<Coordinates<2>> polygon;
    for (int i = 0; i < n; ++i) {
        const double angle = 6.2831853 * (i + 0.8 * unit(random)) / n, x = radius * std::cos(angle),
                     y = radius * squeeze * std::sin(angle);
        polygon.push_back({x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)});
    }
    return polygon;
}

inline std::vector<annulus::Corner_2> straight(const std::vector<Coordinates<2>>& polygon) {
    std::vector<annulus::Corner_2> corners;
    for (const Coordinates<2>& p : polygon) corners.push_back({p, false});
    return corners;
}

}  // namespace oracle
