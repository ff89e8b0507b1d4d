// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <annulus/motion/moments_2.h>
#include <annulus/motion/moments_sin2.h>

#include <catch2/catch.hpp>

#include <support/repeats.h>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

using namespace annulus;

namespace {

constexpr double pi = std::numbers::pi;

/// Errors relative to mass and mass times h, in units of what is promised: 1e-13, and a few roundings of the distance
/// in the sine.
double error(const Moments_2& got, const oracle::Moments& exact, double h, double r) {
    const auto mass = std::abs(got.mass / exact.mass - 1);
    const auto first = std::hypot(got.first[0] - exact.x, got.first[1] - exact.y) / (exact.mass * h);
    return static_cast<double>(std::max(mass, first)) / (1e-13 + 4e-15 * r / h);
}

/// Adds what is between the chord and the arc of radius R from `angle` on, moments about c.
void add_segment(oracle::Moments& sum, oracle::Point c, oracle::Real R, oracle::Real angle, oracle::Real span) {
    using oracle::Real;
    const int pieces = 1 + static_cast<int>(span / 0.05L);
    for (int i = 0; i < pieces; ++i)
        for (const auto& [t, weight] : oracle::gauss5()) {
            const Real at = (i + t) / pieces * span, inner = R * std::cos(span / 2) / std::cos(at - span / 2);
            const Real x = std::cos(angle + at), y = std::sin(angle + at);
            for (const auto& [s, weight2] : oracle::gauss5()) {
                const Real r = inner + s * (R - inner), w = weight * weight2 * span / pieces * (R - inner) * r *
                                                            oracle::density(Density::sin2, r, 0);
                sum.mass += w;
                sum.x += w * (r * x - c.x);
                sum.y += w * (r * y - c.y);
            }
        }
}

}  // namespace

// Sizes at which nodes and degree just suffice (h of 0.06 to 0.1, 0.15 to 0.2, 0.4 to 0.5 are the borders), at which a
// cell is as large as a far one may be, as close to (0, 0), and around zeros of the density, where it is smallest
// beside its derivatives.
TEST_CASE("sin2 moments of far cells keep the promise where it is tightest", "[motion][moments]") {
    const std::uint64_t seed = GENERATE(1u, 2u, 3u);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    double worst = 0;
    for (const double h :
         {0.003, 0.01, 0.03, 0.05, 0.06, 0.07, 0.08, 0.1, 0.12, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.7, 1.0, 1.499})
        for (const int place : {0, 1, 2, 3})
            for (int i = 0; i < repeats(h < 0.3 ? 60 : 10); ++i) {
                const double u = unit(random), turn = 2 * pi * unit(random);
                const double far = std::pow(10, 1 + 5 * u);  // beyond 1e5 another sine is taken
                const double r = place == 0   ? h * (4.0001 + u * u)
                                 : place == 1 ? 4.0001 * h + 20 * u
                                 : place == 2 ? pi * (1 + static_cast<double>(random() % 4)) + h * (2 * u - 1)
                                              : far;
                const Coordinates<2> c{r * std::cos(turn), r * std::sin(turn)};
                const auto polygon = oracle::random_polygon(random, h);
                const auto exact = oracle::polygon(Density::sin2, c, polygon, std::max(0.06, h / 4));
                const double e = error(moments(Density::sin2, c, oracle::straight(polygon)), exact, h, r);
                worst = std::max(worst, e);
                CAPTURE(seed, h, place, i, r, turn);
                CHECK(e < 1);
            }
    std::printf("sin2, far cells: seed %d, worst error %.2f of what is promised\n", static_cast<int>(seed), worst);
}

TEST_CASE("sin2 moments of far cells with an arc for an edge keep the promise", "[motion][moments]") {
    const std::uint64_t seed = GENERATE(1u, 2u);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const double radius : {0.8, pi, 2 * pi, 15.0})
        for (const double h : {0.01, 0.05, 0.07, 0.1, 0.15})
            for (int i = 0; i < repeats(20); ++i) {
                // A rectangle with an arc for its outer edge, the origin somewhere in it.
                const double angle = 2 * pi * unit(random), span = h * (0.5 + unit(random)) / radius;
                const double depth = h * (0.4 + 0.6 * unit(random)), at = depth * unit(random),
                             side = span * unit(random);
                const auto on = [&](double r, double a) { return Coordinates<2>{r * std::cos(a), r * std::sin(a)}; };
                const Coordinates<2> c = on(radius - at, angle + side);
                std::vector<Corner_2> corners;
                std::vector<Coordinates<2>> polygon;
                for (const auto& [p, arc] :
                     {std::pair{on(radius, angle), true}, std::pair{on(radius, angle + span), false},
                      std::pair{on(radius - depth, angle + span), false},
                      std::pair{on(radius - depth, angle), false}}) {
                    polygon.push_back({p[0] - c[0], p[1] - c[1]});
                    corners.push_back({polygon.back(), arc});
                }
                auto exact = oracle::polygon(Density::sin2, c, polygon, 0.05L);
                add_segment(exact, {c[0], c[1]}, radius, angle, span);
                CAPTURE(seed, radius, h, i, angle, span, depth, at, side);
                // Here the corners are rounded as well.
                CHECK(error(moments(Density::sin2, c, corners), exact, h, radius) < 2);
            }
}
