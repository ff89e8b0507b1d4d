// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <apps/motion/gauss_legendre.h>
#include <apps/motion/moments_2.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

using namespace annulus;

namespace {

constexpr double pi = std::numbers::pi;

/// Errors relative to mass and mass times h.
double error(const Moments_2& got, const oracle::Moments& exact, double h) {
    const auto mass = std::abs(got.mass / exact.mass - 1);
    const auto first = std::hypot(got.first[0] - exact.x, got.first[1] - exact.y) / (exact.mass * h);
    return static_cast<double>(std::max(mass, first));
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

TEST_CASE("Gauss rules are exact up to their degree", "[motion][moments]") {
    for (int n = 1; n <= Gauss_rule::max_size; ++n)
        for (int k = 0; k < 2 * n; ++k) {
            CAPTURE(n, k);
            double plain = 0, radial = 0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
                plain += gauss_rule(n).weight[i] * std::pow(gauss_rule(n).node[i], k);
                radial += radial_rule(n).weight[i] * std::pow(radial_rule(n).node[i], k);
            }
            CHECK(gauss_rule(n).size == n);
            CHECK(radial_rule(n).size == n);
            CHECK(std::abs(plain - 1.0 / (k + 1)) < 5e-16);
            CHECK(std::abs(radial - 1.0 / (k + 2)) < 5e-16);
        }
}

// Sizes at which a number of nodes just suffices, at which a cell is as large as a far one may be, close to (0, 0), and
// around zeros of the density, where it is smallest relative to its derivatives.
TEST_CASE("sin2 moments keep the promise where it is tightest", "[motion][moments][deep]") {
    const std::uint64_t seed = GENERATE(1u, 2u, 3u);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    double worst = 0;
    for (const double h : {0.003, 0.01, 0.03, 0.05, 0.07, 0.08, 0.09, 0.1, 0.12, 0.15,  0.18, 0.2,
                           0.22,  0.25, 0.3,  0.35, 0.4,  0.45, 0.5,  0.7, 1.0,  1.499, 2.6})
        for (const int place : {0, 1, 2, 3})
            for (int i = 0; i < repeats(h < 0.3 ? 60 : 10); ++i) {
                const double u = unit(random), turn = 2 * pi * unit(random);
                const double far = std::pow(10, 1 + 5 * u);  // beyond 1e5 another sine is taken
                const double r = place == 0   ? h * (4.0001 + u * u) * (i % 4 == 0 ? u : 1)
                                 : place == 1 ? 4.0001 * h + 20 * u
                                 : place == 2 ? pi * (1 + static_cast<double>(random() % 4)) + h * (2 * u - 1)
                                              : far;
                const Coordinates<2> c{r * std::cos(turn), r * std::sin(turn)};
                const auto polygon = oracle::random_polygon(random, h);
                const auto exact = oracle::polygon(Density::sin2, c, polygon, std::max(0.06, h / 6));
                // The guarantee, plus a few roundings of the distance in the sine.
                const double e =
                    error(moments(Density::sin2, c, oracle::straight(polygon)), exact, h) / (1e-9 + 4e-15 * r / h);
                worst = std::max(worst, e);
                CAPTURE(seed, h, place, i, r, turn);
                CHECK(e < 1);
            }
    std::printf("sin2: seed %d, worst error %.2f of what is promised\n", static_cast<int>(seed), worst);
    CHECK(worst > 0.005);  // the guarantee is not far from the error
}

TEST_CASE("sin2 moments of cells with an arc for an edge keep the promise", "[motion][moments]") {
    const std::uint64_t seed = GENERATE(1u, 2u);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (const double radius : {0.8, pi, 2 * pi, 15.0})
        for (const double h : {0.01, 0.05, 0.07, 0.1, 0.15, 0.4})
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
                CHECK(error(moments(Density::sin2, c, corners), exact, h) < 1e-9 + 1e-14 * radius / h);
            }
}

TEST_CASE("any smooth density has the error that is stated", "[motion][moments]") {
    const std::uint64_t seed = 4;
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    // Three waves of different lengths and directions, and a bell; the oracle has its own formulas.
    const auto waves = [](auto x, auto y) {
        using std::cos;
        return 2 + cos(x * 3) * cos(y * 4) - cos(x * 0.7 + 1);
    };
    const auto bell = [](auto x, auto y) {
        using std::exp;
        return exp(-(x * x + y * y) / 2);
    };
    const Smooth_density wavy{[&](const Coordinates<2>& p) { return waves(p[0], p[1]); }, 4, 2, 5};
    const Smooth_density bellshaped{[&](const Coordinates<2>& p) { return bell(p[0], p[1]); }, 1, 1, 2.4};
    double worst = 0;
    for (const double h : {1e-4, 0.01, 0.05, 0.1, 0.2, 0.3, 0.4, 0.6, 1.0, 2.0})
        for (int i = 0; i < repeats(12); ++i) {
            const Coordinates<2> c{4 * unit(random) - 2, 4 * unit(random) - 2};
            const auto polygon = oracle::random_polygon(random, h);
            CAPTURE(seed, h, i);
            for (const bool first : {true, false}) {
                oracle::Moments exact;
                const auto at = [&](oracle::Real x, oracle::Real y) { return first ? waves(x, y) : bell(x, y); };
                for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
                    oracle::add_triangle(exact, at, {c[0], c[1]}, {polygon[0][0], polygon[0][1]},
                                         {polygon[k][0], polygon[k][1]}, {polygon[k + 1][0], polygon[k + 1][1]},
                                         std::max(0.05L, oracle::Real(h) / 12));
                const double e =
                    error(moments(Density_2(first ? wavy : bellshaped), c, oracle::straight(polygon)), exact, h);
                CHECK(e < 1e-9 + 1e-14 / h);
                worst = std::max(worst, e);
            }
        }
    std::printf("smooth densities: worst error %.1e\n", worst);
}
