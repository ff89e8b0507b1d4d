// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/motion/domain_2.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/sampling_2.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>
#include <vector>

using namespace annulus;
using annulus::testing::for_all;

namespace {

using Points = std::vector<Coordinates<2>>;

bool refused(const Points& corners) {
    try {
        (void)Domain_2::polygon(corners);
    } catch (const Error& error) {
        return error.code() == Error_code::bad_input;
    }
    return false;
}

double area_of(const Cell_2& cell) { return moments(Density::one, cell.origin, cell.corners).mass; }

}  // namespace

TEST_CASE("a polygon must be finite, convex and have an area", "[motion][domain]") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK_FALSE(refused({{0, 0}, {1, 0}, {0, 1}}));
    CHECK(refused({}));
    CHECK(refused({{0, 0}, {1, 0}}));
    CHECK(refused({{0, 0}, {1, 0}, {2, 0}}));
    CHECK_FALSE(refused({{0, 0}, {0, 1}, {1, 0}}));      // clockwise
    CHECK(refused({{0, 0}, {2, 0}, {1, 0.5}, {2, 2}}));  // a notch
    CHECK(refused({{0, 0}, {1, 0}, {nan, 1}}));
    CHECK(refused({{0, 0}, {1, 0}, {1, inf}}));
    CHECK(refused({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));  // a spike
    Points star;                                       // goes around twice
    for (int i = 0; i < 5; ++i) star.push_back({std::cos(2.513274 * i), std::sin(2.513274 * i)});
    CHECK(refused(star));
    CHECK_THROWS_AS(Domain_2::disc(0), Error);
    CHECK_THROWS_AS(Domain_2::disc(-1), Error);
    CHECK_THROWS_AS(Domain_2::disc(nan), Error);
    CHECK_THROWS_AS(Domain_2::square(inf), Error);
}

TEST_CASE("repeated and flat corners of a polygon are dropped", "[motion][domain]") {
    const Domain_2 domain = Domain_2::polygon(
        Points{{0.5, 0}, {1, 0}, {1, 0}, {1, 0.25}, {1, 0.5}, {1, 1}, {0, 1}, {0, 0.3}, {0, 0}, {0.25, 0}});
    CHECK(domain.corners().size() == 4);
    CHECK(domain.area() == Approx(1).epsilon(1e-15));
}

TEST_CASE("containment, area, box and extent", "[motion][domain]") {
    const Domain_2 disc = Domain_2::disc(2), square = Domain_2::square(3);
    const Domain_2 away = Domain_2::polygon(Points{{1, 1}, {3, 1}, {1, 2}});
    CHECK(disc.area() == Approx(4 * std::numbers::pi));
    CHECK(square.area() == Approx(36));
    CHECK(away.area() == Approx(1));
    CHECK(disc.contains({2, 0}));
    CHECK_FALSE(disc.well_contains({2, 0}));
    CHECK_FALSE(disc.contains({2 + 1e-12, 0}));
    CHECK(square.contains({3, -3}));
    CHECK(square.well_contains({2.9, -2.9}));
    CHECK_FALSE(square.contains({3 + 1e-12, 0}));
    CHECK_FALSE(away.contains({2.5, 1.5}));
    CHECK(away.contains({1.7, 1.2}));
    CHECK(away.contains({2.9, 1.01}));  // outside of the inscribed disc
    CHECK(away.extent().r_min == Approx(std::sqrt(2)));
    CHECK(away.extent().r_max == Approx(std::sqrt(10)));
    CHECK(square.extent().r_min == 0);
    CHECK(away.bounding_box().upper == Coordinates<2>{3, 2});
}

TEST_CASE("the convex hull of points contains them all", "[motion][domain]") {
    CHECK(for_all("every point is in the hull of the points", [] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        const auto n = *rc::gen::inRange<std::size_t>(3, 200);
        const auto grid = *rc::gen::inRange(0, 2);
        std::mt19937_64 random(seed);
        Points points;
        for (std::size_t i = 0; i < n; ++i) {
            const auto coordinate = [&] {
                return grid ? static_cast<double>(random() % 7) / 7 : static_cast<double>(random()) * 0x1p-64;
            };
            const double x = coordinate(), y = coordinate();
            points.push_back({x, y});
        }
        points.insert(points.end(), {{0, 0}, {1, 0.1}, {0.3, 1}});
        const Domain_2 hull = Domain_2::convex_hull_of(points);
        for (const auto& p : points) RC_ASSERT(hull.contains(p));
        for (const auto& c : hull.corners()) RC_ASSERT(std::find(points.begin(), points.end(), c) != points.end());
    }));
    CHECK_THROWS_AS(Domain_2::convex_hull_of(Points{{0, 0}, {1, 1}, {2, 2}, {3, 3}}), Error);
}

TEST_CASE("a cell clipped to a disc has the area of the parts in it", "[motion][domain]") {
    std::vector<Corner_2> scratch;
    const Domain_2 disc = Domain_2::disc(1);
    const double pi = std::numbers::pi;
    const auto clipped = [&](const Points& polygon, Coordinates<2> origin) {
        Cell_2 cell{origin, {}};
        for (const auto& p : polygon) cell.corners.push_back({{p[0] - origin[0], p[1] - origin[1]}, false});
        disc.clip(cell, scratch);
        return area_of(cell);
    };
    for (const Coordinates<2> o : {Coordinates<2>{0, 0}, Coordinates<2>{0.3, -0.2}}) {
        CHECK(clipped({{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, o) == Approx(pi).epsilon(1e-14));    // disc in polygon
        CHECK(clipped({{2, 2}, {3, 2}, {3, 3}}, o) == 0);                                        // apart
        CHECK(clipped({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, o) == Approx(pi / 4).epsilon(1e-14));    // quarter
        CHECK(clipped({{0, -3}, {3, -3}, {3, 3}, {0, 3}}, o) == Approx(pi / 2).epsilon(1e-14));  // half
        CHECK(clipped({{0.5, -3}, {3, -3}, {3, 3}, {0.5, 3}}, o) ==
              Approx(pi / 3 - std::sqrt(3) / 4).epsilon(1e-13));  // segment
        CHECK(clipped({{-0.5, -3}, {3, -3}, {3, 3}, {-0.5, 3}}, o) ==
              Approx(pi * 2 / 3 + std::sqrt(3) / 4).epsilon(1e-14));  // more than half
        CHECK(clipped({{-3, -0.5}, {3, -0.5}, {3, 0.5}, {-3, 0.5}}, o) ==
              Approx(pi / 3 + std::sqrt(3) / 2).epsilon(1e-14));                               // strip, two arcs
        CHECK(clipped({{-1, 0}, {0, -1}, {1, 0}, {0, 1}}, o) == Approx(2).epsilon(1e-14));     // inscribed
        CHECK(clipped({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, o) == Approx(pi).epsilon(1e-14));  // touching
        const double c = 0.8;                                                                  // four arcs
        const double cap = std::acos(c) - c * std::sqrt(1 - c * c);
        CHECK(clipped({{-c, -c}, {c, -c}, {c, c}, {-c, c}}, o) == Approx(pi - 4 * cap).epsilon(1e-14));
    }
}

TEST_CASE("an arc spans less than a turn, and nothing when rounding turned it back", "[motion][domain]") {
    const double pi = std::numbers::pi;
    CHECK(arc_span({0, 0}, {1, 0}, {0, 1}) == Approx(pi / 2));
    CHECK(arc_span({0, 0}, {0, 1}, {1, 0}) == Approx(3 * pi / 2));
    CHECK(arc_span({1, 0}, {0, 0}, {0, 1e-15}) == Approx(1e-15).margin(0));
    CHECK(arc_span({1, 0}, {0, 1e-15}, {0, 0}) == 0);
    CHECK(arc_span({1, 0}, {0, 1e-15}, {0, 1e-15}) == 0);
}

TEST_CASE("a cell clipped to a polygon is their intersection", "[motion][domain]") {
    std::vector<Corner_2> scratch;
    const Domain_2 triangle = Domain_2::polygon(Points{{0, 0}, {2, 0}, {0, 2}});
    Cell_2 cell{{5, 5}, {{{-5, -5}, false}, {{-3.5, -5}, false}, {{-3.5, -4}, false}, {{-5, -4}, false}}};
    triangle.clip(cell, scratch);  // [0, 1.5] x [0, 1] without the corner above x + y = 2
    CHECK(cell.corners.size() == 5);
    CHECK(area_of(cell) == Approx(1.5 - 0.125).epsilon(1e-14));
    Cell_2 far{{5, 5}, {{{0, 0}, false}, {{1, 0}, false}, {{0, 1}, false}}};
    triangle.clip(far, scratch);
    CHECK(far.corners.empty());
}

TEST_CASE("samples are in the domain, differ, repeat, and follow the density", "[motion][sampling]") {
    const std::uint64_t seed = 11;
    CAPTURE(seed);
    const Domain_2 domains[] = {Domain_2::disc(4), Domain_2::square(2),
                                Domain_2::polygon(Points{{1, -1}, {5, 0}, {4, 3}, {2, 2}})};
    for (const Domain_2& domain : domains)
        for (const Density density : all_densities) {
            CAPTURE(std::string(name_of(density)), domain.area());
            const std::size_t n = 40000;
            const auto points = sample(domain, density, n, seed);
            REQUIRE(points.size() == n);
            CHECK(points == sample(domain, density, n, seed));
            CHECK(points != sample(domain, density, n, seed + 1));
            CHECK(std::set(points.begin(), points.end()).size() == n);
            double x = 0, y = 0, x2 = 0, y2 = 0;
            for (const auto& p : points) {
                REQUIRE(domain.contains(p));
                x += p[0] / n, y += p[1] / n, x2 += p[0] * p[0] / n, y2 += p[1] * p[1] / n;
            }
            const Cell_2 whole = domain.whole({0, 0});
            const Moments_2 m = moments(density, whole.origin, whole.corners);
            // Five standard deviations of the mean.
            CHECK(std::abs(x - m.first[0] / m.mass) < 5 * std::sqrt((x2 - x * x) / n));
            CHECK(std::abs(y - m.first[1] / m.mass) < 5 * std::sqrt((y2 - y * y) / n));
        }
    // The density matters: the mean of r^2 under r^2 in a disc of radius R is 2 R^2 / 3, under 1 it is R^2 / 2.
    double r2 = 0;
    for (const auto& p : sample(domains[0], Density::x2_plus_y2, 40000, seed))
        r2 += (p[0] * p[0] + p[1] * p[1]) / 40000;
    CHECK(r2 == Approx(16 * 2 / 3.0).epsilon(0.01));
    // The standard fixes the generator: this point must never change.
    const auto first = sample(Domain_2::square(1), Density::one, 1, 0);
    std::mt19937_64 bits(0);
    const double s = static_cast<double>(bits() >> 11) * 0x1p-53, t = static_cast<double>(bits() >> 11) * 0x1p-53;
    const double pick = static_cast<double>(bits() >> 11) * 0x1p-53;
    const double fs = s + t > 1 ? 1 - s : s, ft = s + t > 1 ? 1 - t : t;
    CHECK(first[0] == (pick < 0.5 ? Coordinates<2>{-1 + 2 * fs + 2 * ft, -1 + 2 * ft}
                                  : Coordinates<2>{-1 + 2 * fs, -1 + 2 * fs + 2 * ft}));
}

TEST_CASE("a domain with too few doubles in it is refused, not searched forever", "[motion][sampling]") {
    const double e = std::numeric_limits<double>::epsilon();
    const Domain_2 speck = Domain_2::polygon(Points{{1, 1}, {1 + 2 * e, 1}, {1 + 2 * e, 1 + 2 * e}, {1, 1 + 2 * e}});
    CHECK(sample(speck, Density::one, 4, 1).size() == 4);
    CHECK_THROWS_AS(sample(speck, Density::one, 100, 1), Error);
}
