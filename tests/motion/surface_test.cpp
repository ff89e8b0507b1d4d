// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/error.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/surface_3.h>
#include <apps/motion/surface_faults.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

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

TEST_CASE("nearest points are the same whatever was kept of earlier questions", "[motion][surface]") {
    Triangle_surface needles = round_octahedron(2), far = dented(), tiny = dented();
    for (auto& p : needles.points) p[0] *= 1e-7, p[1] *= 1e-3;
    for (auto& p : far.points) p[2] += 1e5;
    for (auto& p : tiny.points)
        for (double& x : p) x *= 1e-25;
    const Triangle_surface shape =
        GENERATE_COPY(box({0.9, 0.5, 0.02}), round_octahedron(0), round_octahedron(4), dented(), needles, far, tiny);
    const Surface_3 surface(shape, true);
    const Domain_3::Box box = surface.bounding_box();
    const double size = distance(box.lower, box.upper), rounding = 1e-13 * (size + distance({}, box.upper));
    std::mt19937_64 bits(31);
    const auto number = [&] { return std::uniform_real_distribution<double>(-1, 1)(bits); };
    // The last three: each step, from a hundredth to thousands of sizes.
    for (const double log_stride : {-12.0, -4.0, -2.0, 0.0, 3.0, 200.0}) {
        CAPTURE(log_stride);
        Nearby_3 nearby;
        Coordinates<3> p = surface.surface_sample(1, 5)[0], near = p;
        std::size_t same_ball = 0;
        for (int step = 0; step < (log_stride < 0 ? 600 : 150); ++step) {  // CGAL is slow for far points
            const double stride =
                size * std::pow(10, log_stride < 0 ? log_stride : log_stride * std::abs(number()) - 2);
            for (double& x : p) x += stride * number();
            // Mostly close to the surface, like vertices, sometimes on it, at a corner, or with a `near` that is not
            // near.
            if (step % 5 == 1) p = surface.project(p);
            if (step % 100 == 50) p = shape.points[static_cast<std::size_t>(step) % shape.points.size()];
            if (step % 70 == 30) near = p;
            if (step % 70 == 31) near[1] += 100 * size;
            const Coordinates<3> centre = nearby.centre, got = surface.project(p, near, nearby);
            same_ball += nearby.centre == centre;
            Nearby_3 nothing;
            REQUIRE(got == surface.project(p, near, nothing));
            const Coordinates<3> nearest = surface.project(p);
            if (std::isfinite(distance(p, nearest) * distance(p, nearest)))
                REQUIRE(std::abs(distance(p, got) - distance(p, nearest)) <= rounding + 1e-15 * distance(p, nearest));
            REQUIRE(distance(got, surface.project(got)) <= rounding);
            near = got;
            if (distance(p, got) > 0.1 * size && log_stride < 3) p = got;
        }
        if (log_stride == -4.0) CHECK(same_ball > 360);
        CHECK(nearby.parts.size() <= 48);
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

TEST_CASE("edges of a surface that is not closed are found with their triangles", "[motion][surface]") {
    using Kind = Edge_fault::Kind;
    const Triangle_surface whole = box({1, 1, 1});
    CHECK(!edge_fault(whole.triangles));
    auto t = whole.triangles;
    std::swap(t[3][1], t[3][2]);
    REQUIRE(edge_fault(t));
    CHECK(edge_fault(t)->kind == Kind::turned);
    CHECK((edge_fault(t)->triangle == 3 || edge_fault(t)->other == 3));
    t = whole.triangles;
    t.push_back(t[5]);
    CHECK(edge_fault(t)->kind == Kind::crowded);
    CHECK(edge_fault(t)->count == 3);
    CHECK(edge_fault(t)->triangle == 12);
    t = whole.triangles;
    t.erase(t.begin());
    CHECK(edge_fault(t)->kind == Kind::open);
    CHECK(edge_fault(t)->triangle == 0);
}

TEST_CASE("two boxes cross where their sides say", "[motion][surface]") {
    const Coordinates<3> half{0.75, 0.5, 0.25};
    std::size_t crossed = 0;
    auto shifts = random_points(600, 21);
    for (std::size_t i = 0; i < 60; ++i)  // sides, edges and corners that touch
        for (std::size_t k = 0; k < 3; ++k)
            if ((i >> k & 1) != 0) shifts[i][k] = std::copysign(k == i % 3 ? 1.0 : 0.5, shifts[i][k]);
    for (const auto& shift : shifts) {
        Triangle_surface s = box(half), other = s;
        bool meet = true;
        for (std::size_t k = 0; k < 3; ++k) meet = meet && std::abs(2 * half[k] * shift[k]) <= 2 * half[k];
        for (auto& p : other.points)
            for (std::size_t k = 0; k < 3; ++k) p[k] += 2 * half[k] * shift[k];
        s.points.insert(s.points.end(), other.points.begin(), other.points.end());
        for (const auto& t : other.triangles) s.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        crossed += meet;
        CHECK(crossing_triangles(s).has_value() == meet);
    }
    CHECK(crossed > 100);
}

TEST_CASE("a surface that crosses itself is refused, unless it may", "[motion][surface]") {
    CHECK(!crossing_triangles(dented(0.25)));
    for (const double depth : {0.4, 0.6}) {
        const Triangle_surface crossing = dented(depth);  // triangles that share corners, too
        CHECK(crossing_triangles(crossing));
        CHECK_THROWS_WITH(Surface_3(crossing), Catch::Matchers::StartsWith("it crosses or touches itself near ("));
        CHECK_NOTHROW(Surface_3(crossing, true));
    }
    // One on the other: all edges are in two triangles.
    const Triangle_surface flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    CHECK(!edge_fault(flat.triangles));
    CHECK(crossing_triangles(flat));
    // Folded at an edge: the tetrahedron 0 1 2 3 with corner 3 in the plane of the others and on their side.
    Triangle_surface folded = box({1, 1, 1});
    folded.points[7] = {0, 0, -1};
    CHECK(crossing_triangles(folded));
    folded = box({1, 1, 1});
    folded.points[7] = {-1, -1, 0};  // on an edge: that triangle has no area
    folded.points[3] = {-1, -1, 0.5};
    CHECK_THROWS_AS(Surface_3(folded), Error);
    folded.points[7] = {-1, -1, std::nan("")};
    CHECK_THROWS_AS(Surface_3(folded), Error);
}

TEST_CASE("lengths that CGAL's constructions cannot bear are refused, small coordinates are zeros",
          "[motion][surface]") {
    const auto code = [](double scale, double shift) {
        Triangle_surface s = box({1, 1, 1});
        for (auto& p : s.points)
            for (double& x : p) x = scale * (x + shift);
        try {
            const Surface_3 surface(s);
            CHECK(surface.contains({scale * shift, scale * shift, scale * shift}));
            const auto p = surface.project({scale * shift, scale * shift, scale * (shift + 3)});
            CHECK(p[2] == Approx(scale * (shift + 1)));
            return true;
        } catch (const Error& e) {
            CHECK(e.code() == Error_code::out_of_domain);
            return false;
        }
    };
    for (const double scale : {1e-29, 1.0, 1e11}) CHECK(code(scale, 0));
    for (const double scale : {1e-31, 1e13, 1e-300, 1e300}) CHECK(!code(scale, 0));
    CHECK(code(1, 1e7));
    CHECK(!code(1, 1e8));
    Triangle_surface s = round_octahedron(0);
    for (auto& p : s.points)
        for (double& x : p)
            if (x == 0) x = 1e-320;
    const Surface_3 surface(s);  // CGAL's nearest point was no number
    for (const auto& p : random_points(50, 22)) CHECK(std::isfinite(surface.project(p)[0]));
    const double nan = std::nan("");
    CHECK(!surface.crossing({0, 0, 0}, {nan, 0, 0}));
    CHECK(!surface.crossing({0, 0, 0}, {std::numeric_limits<double>::infinity(), 0, 0}));
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
