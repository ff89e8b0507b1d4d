// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <annulus/error.h>
#include <apps/motion/density_2.h>
#include <apps/motion/moments_2.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

using namespace annulus;

namespace {

constexpr double pi = std::numbers::pi;

/// The worst relative errors of `tries` random cells of `radius` at distance about `distance` from (0, 0): mass
/// relative to mass, first moments relative to mass times radius.
double worst_error(Density density, double radius, double distance, int tries, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> angle(0, 2 * pi), about(0.8, 1.2);
    double worst = 0;
    for (int i = 0; i < repeats(tries); ++i) {
        const double r = distance * about(random), a = angle(random);
        const Coordinates<2> c{r * std::cos(a), r * std::sin(a)};
        const auto polygon = oracle::random_polygon(random, radius);
        const auto exact = oracle::polygon(density, c, polygon, density == Density::sin2 ? 0.12L : 1e9L);
        const Moments_2 got = moments(density, c, oracle::straight(polygon));
        const auto mass_error = std::abs(got.mass - exact.mass) / exact.mass;
        const auto first_error = std::hypot(got.first[0] - exact.x, got.first[1] - exact.y) / (exact.mass * radius);
        worst = std::max(worst, static_cast<double>(std::max(mass_error, first_error)));
    }
    return worst;
}

}  // namespace

TEST_CASE("polynomial moments of a polygon are exact to rounding wherever it is", "[motion][moments]") {
    const std::uint64_t seed = GENERATE(1u, 2u);
    for (const Density density : {Density::one, Density::x2_plus_y2, Density::x2})
        for (const double radius : {1e-7, 1e-3, 1.0, 50.0})
            for (const double distance : {0.0, 1e-3, 1.0, 1e3, 1e6}) {
                CAPTURE(seed, std::string(name_of(density)), radius, distance);
                CHECK(worst_error(density, radius, distance, 30, seed) < 5e-15);
            }
}

TEST_CASE("sin2 moments of a polygon have the stated relative error", "[motion][moments]") {
    const std::uint64_t seed = GENERATE(1u, 2u);
    for (const double radius : {1e-4, 1e-2, 0.1, 0.3, 0.6, 0.99, 1.01, 1.49, 1.51, 2.5})
        for (const double distance : {0.0, 1e-3, 0.05, 0.5, 1.5, 3.14, 6.3, 20.0, 56.0}) {
            CAPTURE(seed, radius, distance);
            // One rounding of the distance shifts the density by as much: relative to the cell, eps distance / radius,
            // and twice that in the density.
            const double shift = 4e-16 * distance / radius;
            CHECK(worst_error(Density::sin2, radius, distance, radius < 0.5 ? 8 : 3, seed) < 1e-9 + 10 * shift);
        }
}

TEST_CASE("sin2 moments of a cell on a zero of the density keep their relative error", "[motion][moments]") {
    const std::uint64_t seed = 5;
    std::mt19937_64 random(seed);
    for (const double radius : {1e-3, 0.05, 0.3, 0.65, 0.99})
        for (const int zero : {1, 2, 5, 18}) {
            CAPTURE(seed, radius, zero);
            const Coordinates<2> c{zero * pi * 0.6, zero * pi * 0.8};
            for (int i = 0; i < 5; ++i) {
                const auto polygon = oracle::random_polygon(random, radius);
                const auto exact = oracle::polygon(Density::sin2, c, polygon, 0.12L);
                const Moments_2 got = moments(Density::sin2, c, oracle::straight(polygon));
                // Here a shift of the density by one rounding of the distance counts twice, more if narrow.
                const double allowed = 1e-9 + 4e-15 * zero * pi / radius;
                CHECK(std::abs(got.mass / exact.mass - 1) < allowed);
                CHECK(std::abs(got.first[0] - exact.x) < allowed * exact.mass * radius);
                CHECK(std::abs(got.first[1] - exact.y) < allowed * exact.mass * radius);
            }
        }
}

TEST_CASE("moments of a disc have their closed form from any origin in it", "[motion][moments]") {
    for (const double radius : {1e-3, 0.3, 1.0, 3.0, 56.4})
        for (const double shift : {0.0, 0.4, 0.99}) {
            CAPTURE(radius, shift);
            const Coordinates<2> origin{radius * shift * 0.6, radius * shift * 0.8};
            std::vector<Corner_2> disc;
            assign_disc(origin, radius, disc);
            const double r2 = radius * radius;
            // Integral of sin^2(t) t over [0, R], by its series where the closed form cancels.
            const double g = radius < 0.01
                                 ? r2 * r2 / 4 - r2 * r2 * r2 / 18
                                 : r2 / 4 - radius * std::sin(2 * radius) / 4 - std::cos(2 * radius) / 8 + 0.125;
            for (const auto& [density, mass] :
                 {std::pair{Density::one, pi * r2}, std::pair{Density::x2_plus_y2, pi * r2 * r2 / 2},
                  std::pair{Density::x2, pi * r2 * r2 / 4}, std::pair{Density::sin2, 2 * pi * g}}) {
                CAPTURE(std::string(name_of(density)));
                const Moments_2 got = moments(density, origin, disc);
                const double allowed = density == Density::sin2 ? 1e-9 : 1e-13;
                CHECK(std::abs(got.mass / mass - 1) < allowed);
                CHECK(std::abs(got.first[0] + mass * origin[0]) < allowed * mass * radius);
                CHECK(std::abs(got.first[1] + mass * origin[1]) < allowed * mass * radius);
            }
        }
}

TEST_CASE("moments of a half disc have their closed form", "[motion][moments]") {
    const double radius = GENERATE(0.3, 0.9, 2.0, 40.0);
    const std::vector<Corner_2> half{{{radius, 0}, true}, {{-radius, 0}, false}};  // y > 0
    const double r3 = radius * radius * radius, r5 = r3 * radius * radius, s = std::sin(2 * radius),
                 c = std::cos(2 * radius);
    const double h = r3 / 6 - (radius * radius / 4 - 0.125) * s - radius * c / 4;  // integral of sin^2(t) t^2
    for (const auto& [density, first] :
         {std::pair{Density::one, 2 * r3 / 3}, std::pair{Density::x2_plus_y2, 2 * r5 / 5},
          std::pair{Density::x2, 2 * r5 / 15}, std::pair{Density::sin2, 2 * h}}) {
        CAPTURE(radius, std::string(name_of(density)));
        const Moments_2 got = moments(density, {0, 0}, half);
        const double allowed = density == Density::sin2 ? 1e-9 : 1e-13;
        CHECK(got.first[1] == Approx(first).epsilon(allowed));
        CHECK(std::abs(got.first[0]) < allowed * first);
    }
}

TEST_CASE("moments of a circular segment, however thin, have their closed form", "[motion][moments]") {
    const double radius = GENERATE(0.7, 10.0);
    for (const double span : {1e-5, 1e-3, 0.1, 1.0, 3.0, 5.5}) {
        CAPTURE(radius, span);
        const double start = 0.3, middle = start + span / 2;
        const Coordinates<2> p{radius * std::cos(start), radius * std::sin(start)};
        const Coordinates<2> q{radius * std::cos(start + span), radius * std::sin(start + span)};
        const std::vector<Corner_2> segment{{{0, 0}, true}, {{q[0] - p[0], q[1] - p[1]}, false}};
        const Moments_2 got = moments(Density::one, p, segment);
        // span - sin(span) without cancellation
        const double less = span < 0.2 ? std::pow(span, 3) / 6 *
                                             (1 - span * span / 20 * (1 - span * span / 42 * (1 - span * span / 72)))
                                       : span - std::sin(span);
        const double area = radius * radius / 2 * less;
        const double out = 4 * radius * std::pow(std::sin(span / 2), 3) / (3 * less);  // centroid's distance
        // The end points are rounded to 1e-16 radius, and the area goes with the cube of their distance.
        const double allowed = 1e-13 + 2e-15 / span;
        CHECK(std::abs(got.mass / area - 1) < allowed);
        CHECK(std::abs(p[0] + got.first[0] / got.mass - out * std::cos(middle)) <
              1e-13 * radius + allowed * radius * span);
        CHECK(std::abs(p[1] + got.first[1] / got.mass - out * std::sin(middle)) <
              1e-13 * radius + allowed * radius * span);
    }
}

TEST_CASE("sin2 moments of caps add up", "[motion][moments][deep]") {
    // A sector piece between two circles would need a clockwise arc; a cap does: moments are additive, so the cap cut
    // by a ray through its middle must give the cap.
    for (const double radius : {0.8, 1.3, 4.0, 30.0, 56.0})
        for (const double span : {0.02, 0.1, 0.4}) {
            CAPTURE(radius, span);
            const auto on = [&](double angle) {
                return Coordinates<2>{radius * std::cos(angle), radius * std::sin(angle)};
            };
            const Coordinates<2> a = on(0.5), m = on(0.5 + span / 2), b = on(0.5 + span);
            const Coordinates<2> inner{(a[0] + b[0]) / 2 * 0.97, (a[1] + b[1]) / 2 * 0.97};
            const auto off = [&](const Coordinates<2>& p) { return Coordinates<2>{p[0] - inner[0], p[1] - inner[1]}; };
            const auto whole =
                moments(Density::sin2, inner, std::vector<Corner_2>{{{0, 0}, false}, {off(a), true}, {off(b), false}});
            const auto left =
                moments(Density::sin2, inner, std::vector<Corner_2>{{{0, 0}, false}, {off(a), true}, {off(m), false}});
            const auto right =
                moments(Density::sin2, inner, std::vector<Corner_2>{{{0, 0}, false}, {off(m), true}, {off(b), false}});
            const double allowed = 1e-9 + 1e-14 * radius / (radius * span);
            CHECK(std::abs((left.mass + right.mass) / whole.mass - 1) < allowed);
            // Polar form: the cap plus the triangle (0, 0), a, b is a sector.
            const auto triangle = oracle::polygon(Density::sin2, {0, 0}, {{0, 0}, a, inner}, 0.25L);
            const auto triangle2 = oracle::polygon(Density::sin2, {0, 0}, {{0, 0}, inner, b}, 0.25L);
            // The integral of sin^2(t) t over [0, radius].
            const double g = radius * radius / 4 - radius * std::sin(2 * radius) / 4 - std::cos(2 * radius) / 8 + 0.125;
            const double parts = static_cast<double>(triangle.mass + triangle2.mass) + whole.mass;
            CHECK(std::abs(parts - g * span) < 1e-9 * g * span);
        }
}

TEST_CASE("densities parse, print and are bounded", "[motion][density]") {
    for (const Density density : all_densities) CHECK(parse_density(name_of(density)) == density);
    CHECK(name_of(Density::x2_plus_y2) == "x2+y2");
    CHECK_THROWS_AS(parse_density("x3"), Error);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < 2000; ++i) {
        const double r_min = 8 * unit(random), r_max = r_min + 2 * unit(random) * unit(random);
        double attained[4] = {}, abs_x = 0;
        const Extent_2 ring{r_min, r_max, r_max};
        for (int k = 0; k <= 50; ++k) {
            const double r = k == 50 ? r_max : r_min + (r_max - r_min) * k / 50, a = k == 50 ? 0 : 6.3 * unit(random);
            const Coordinates<2> p{r * std::cos(a), r * std::sin(a)};
            abs_x = std::max(abs_x, std::abs(p[0]));
            for (const Density density : all_densities) {
                const double at = density_at(density, p);
                REQUIRE(at <= density_upper_bound(density, ring));
                auto& best = attained[static_cast<int>(density)];
                best = std::max(best, at);
            }
        }
        for (const Density density : all_densities)
            REQUIRE(attained[static_cast<int>(density)] >= 0.97 * density_upper_bound(density, ring) - 1e-12);
    }
}
