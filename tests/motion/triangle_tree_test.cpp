// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/motion/triangle_tree.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace annulus;
using namespace annulus_test;

namespace {

using Real = long double;
using Vector = std::array<Real, 3>;

Real distance(const Vector& p, const Vector& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }
Vector real(const Coordinates<3>& p) { return {p[0], p[1], p[2]}; }
double distance(const Coordinates<3>& p, const Coordinates<3>& q) { return static_cast<double>(distance(real(p), real(q))); }

/// How far p is from a segment, by ternary search: the distance is convex along it.
Real from_segment(const Vector& a, const Vector& b, const Vector& p, Vector* foot = nullptr) {
    Real low = 0, high = 1;
    const auto at = [&](Real t) { return Vector{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])}; };
    for (int i = 0; i < 200; ++i) {
        const Real s = (2 * low + high) / 3, t = (low + 2 * high) / 3;
        (distance(at(s), p) < distance(at(t), p) ? high : low) = distance(at(s), p) < distance(at(t), p) ? t : s;
    }
    if (foot) *foot = at(low);
    return std::min({distance(at(low), p), distance(a, p), distance(b, p)});
}

/// And from a triangle: among segments from a corner to the opposite side, the same once more.
double from_triangle(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c, const Coordinates<3>& p) {
    const Vector x = real(a), y = real(b), z = real(c), q = real(p);
    Real low = 0, high = 1;
    const auto across = [&](Real t) {
        return from_segment(x, {y[0] + t * (z[0] - y[0]), y[1] + t * (z[1] - y[1]), y[2] + t * (z[2] - y[2])}, q);
    };
    for (int i = 0; i < 60; ++i) {
        const Real s = (2 * low + high) / 3, t = (low + 2 * high) / 3;
        if (across(s) < across(t)) high = t;
        else low = s;
    }
    return static_cast<double>(std::min({across(low), across(0), across(1)}));
}

}  // namespace

TEST_CASE("the nearest point of a triangle is in it and nearest", "[motion][surface]") {
    const auto points = random_points(4 * 60, 17);
    for (std::size_t i = 0; i + 3 < points.size(); i += 4) {
        CAPTURE(i);
        for (const double thin : {1.0, 1e-3, 1e-9}) {
            const Coordinates<3>&a = points[i], &b = points[i + 1], &p = points[i + 3];
            Coordinates<3> c;  // near the line from a to b where thin
            for (std::size_t k = 0; k < 3; ++k) c[k] = a[k] + 0.4 * (1 - thin) * (b[k] - a[k]) + thin * (points[i + 2][k] - a[k]);
            const Coordinates<3> q = nearest_in_triangle(a, b, c, p);
            CHECK(from_triangle(a, b, c, q) < 1e-9);
            CHECK(distance(p, q) == Approx(from_triangle(a, b, c, p)).epsilon(1e-9));
        }
        // A corner, a side, and no triangle at all.
        CHECK(nearest_in_triangle(points[i], points[i + 1], points[i + 2], points[i]) == points[i]);
        const Coordinates<3> point = nearest_in_triangle(points[i], points[i], points[i], points[i + 3]);
        CHECK(point == points[i]);
    }
}

TEST_CASE("a tree of triangles finds what looking at all of them finds, with a point that is near or without", "[motion][surface]") {
    for (const int times : {0, 1, 3}) {
        const Triangle_surface s = round_octahedron(times);
        const Triangle_tree tree(s);
        for (const auto& x : random_points(300, 18)) {
            const Coordinates<3> p{1.5 * x[0], 1.5 * x[1], 1.5 * x[2]};
            double least = std::numeric_limits<double>::infinity();
            for (const auto& t : s.triangles) {
                const auto at = [&](std::size_t k) { return s.points[static_cast<std::size_t>(t[k])]; };
                least = std::min(least, distance(p, nearest_in_triangle(at(0), at(1), at(2), p)));
            }
            const Coordinates<3> q = tree.nearest(p);
            CHECK(distance(p, q) == Approx(least).epsilon(1e-14));
            CHECK(distance(p, tree.nearest(p, q)) == Approx(least).epsilon(1e-14));
            CHECK(distance(p, tree.nearest(p, s.points[0])) == Approx(least).epsilon(1e-14));
            CHECK(distance(p, tree.nearest(p, p)) == Approx(least).epsilon(1e-14));  // a promise not kept
            CHECK(distance(q, tree.nearest(q, q)) < 1e-14);
        }
    }
}
