// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/arithmetic/error.h>
#include <annulus/motion/ball_3.h>
#include <annulus/motion/surface_3.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace annulus;
using namespace annulus_test;

namespace {

double distance(const Coordinates<3>& a, const Coordinates<3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

TEST_CASE("a point is in a surface that winds around it, with the grid and without", "[motion][surface]") {
    const Triangle_surface shape = GENERATE(box({0.9, 0.5, 0.02}), round_octahedron(0), round_octahedron(3), dented());
    const Surface_3 surface(shape);
    std::size_t inside = 0;
    for (auto p : random_points(4000, 11)) {
        for (std::size_t k = 0; k < 3; ++k) p[k] *= 1.05 * surface.bounding_box().upper[k];
        const bool expected = winding(shape, p) > 0.5;
        inside += expected;
        CHECK(surface.contains(p) == expected);
        CHECK(surface.contains_by_ray(p) == expected);
    }
    CHECK(inside > 400);
    CHECK(inside < 3900);
}

TEST_CASE("points beyond the box, infinite ones and NaN are in no surface", "[motion][surface]") {
    const Surface_3 surface(box({1, 1, 1}));
    const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
    for (const double x : {1.0, 1.1, 1e300, inf, -inf, nan}) {
        CHECK_FALSE(surface.contains({x, 0, 0}));
        CHECK_FALSE(surface.contains({0, 0, x}));
    }
    CHECK(surface.contains({0.999, -0.999, 0.999}));
}

TEST_CASE("a projection is the nearest point", "[motion][surface]") {
    const Coordinates<3> s{0.9, 0.5, 0.25};
    const Surface_3 surface(box(s));
    for (const auto& p : random_points(2000, 12)) {
        Coordinates<3> nearest = p;  // clamped to the box; from inside, to its nearest side
        bool inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
            nearest[k] = std::clamp(p[k], -s[k], s[k]);
            inside = inside && std::abs(p[k]) < s[k];
        }
        if (inside) {
            std::size_t side = 0;
            for (std::size_t k = 1; k < 3; ++k)
                if (s[k] - std::abs(p[k]) < s[side] - std::abs(p[side])) side = k;
            nearest[side] = std::copysign(s[side], p[side]);
        }
        CHECK(distance(surface.project(p), nearest) < 1e-15);
    }
}

TEST_CASE("a segment crosses the box where its sides say", "[motion][surface]") {
    const Surface_3 surface(box({1, 1, 1}));
    const auto ends = random_points(1000, 13);
    std::size_t crossings = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        Coordinates<3> a = ends[i], b = ends[i + 1];
        for (double& x : b) x *= 3;
        const auto p = surface.crossing(a, b);
        const bool out = std::max({std::abs(b[0]), std::abs(b[1]), std::abs(b[2])}) > 1;
        REQUIRE(p.has_value() == out);
        if (!p) continue;
        ++crossings;
        CHECK(std::abs(std::max({std::abs((*p)[0]), std::abs((*p)[1]), std::abs((*p)[2])}) - 1) < 1e-14);
        CHECK(distance(a, *p) + distance(*p, b) - distance(a, b) < 1e-14);
    }
    CHECK(crossings > 200);
}

TEST_CASE("samples of a surface are on it and spread by area", "[motion][surface]") {
    const Surface_3 surface(box({1, 1, 0.5}));
    const auto samples = surface.surface_sample(8000, 5);
    REQUIRE(samples.size() == 8000);
    CHECK(samples == surface.surface_sample(8000, 5));
    CHECK(samples != surface.surface_sample(8000, 6));
    std::size_t on_caps = 0;
    for (const auto& p : samples) {
        CHECK(distance(surface.project(p), p) < 1e-15);
        on_caps += std::abs(std::abs(p[2]) - 0.5) < 1e-12;
    }
    // The caps have half of the area: 4000 with a standard deviation of 45.
    CHECK(std::abs(static_cast<double>(on_caps) - 4000) < 300);
}

TEST_CASE("volumes", "[motion][surface]") {
    CHECK(Surface_3(box({1, 0.5, 0.25})).volume() == Approx(1.0).epsilon(1e-14));
    CHECK(Surface_3(round_octahedron(0)).volume() == Approx(4.0 / 3).epsilon(1e-14));
    CHECK(Ball_3(2).volume() == Approx(33.510321638291124).epsilon(1e-14));
}

TEST_CASE("a ball is what its radius says", "[motion][surface]") {
    const Ball_3 ball(0.5);
    const auto points = random_points(2000, 14);
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        const auto &a = points[i], &b = points[i + 1];
        CHECK(ball.contains(a) == (distance(a, {}) < 0.5));
        CHECK(std::abs(distance(ball.project(a), {}) - 0.5) < 1e-15);
        CHECK(distance(ball.project(a), a) == Approx(std::abs(distance(a, {}) - 0.5)).margin(1e-14));
        if (const auto p = ball.crossing(a, b)) {
            CHECK(std::abs(distance(*p, {}) - 0.5) < 1e-15);
            CHECK(distance(a, *p) + distance(*p, b) - distance(a, b) < 1e-13);
        } else {
            CHECK(ball.contains(a) == ball.contains(b));
        }
    }
    CHECK_THROWS_AS(Ball_3(0), Error);
}

TEST_CASE("an open surface and one that is turned in places are refused", "[motion][surface]") {
    Triangle_surface open = box({1, 1, 1}), turned = open, twice = open;
    open.triangles.pop_back();
    std::swap(turned.triangles[3][1], turned.triangles[3][2]);
    twice.triangles.push_back(twice.triangles[0]);
    for (const auto& s : {open, turned, twice, Triangle_surface{}}) CHECK_THROWS_AS(Surface_3(s), Error);
}

TEST_CASE("two boxes that touch in a corner are one surface", "[motion][surface]") {
    Triangle_surface s = box({1, 1, 1}), other = s;
    for (auto& p : other.points)
        for (double& x : p) x += 2;
    // Corner 7 of the first is corner 0 of the second.
    const auto shift = [](Index i) { return i == 0 ? Index{7} : i + 7; };
    s.points.insert(s.points.end(), other.points.begin() + 1, other.points.end());
    for (const auto& t : other.triangles) s.triangles.push_back({shift(t[0]), shift(t[1]), shift(t[2])});
    const Surface_3 surface(s);
    for (auto p : random_points(1000, 15)) {
        for (double& x : p) x = 1 + 2.2 * x;
        CHECK(surface.contains(p) == (winding(s, p) > 0.5));
    }
}
