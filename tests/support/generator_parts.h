// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Parts that the families of points, bi-cells and triangles share.
#include "generators.h"

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <utility>

namespace annulus::testing {

inline Point on_circle(double angle, double radius, const Point& centre) {
    return {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
}

inline Point uniform_point(Random& random) { return {between(random, -1, 1), between(random, -1, 1)}; }

/// Integer points on the circle of radius 5 * 13 * 17 * ... (`primes` factors) around 0: a random one of the
/// 4 * 3^primes. Each prime is a Gaussian norm, and its square splits in three ways.
inline Point pythagorean(Random& random, int primes) {
    static constexpr std::array<std::pair<int, int>, 7> factors{
        {{2, 1}, {3, 2}, {4, 1}, {5, 2}, {6, 1}, {5, 4}, {7, 2}}};
    std::complex<double> z(1, 0);  // integers below 2^41: exact
    const auto times = [&z](double x, double y) { z = {z.real() * x - z.imag() * y, z.real() * y + z.imag() * x}; };
    for (int i = 0; i < primes; ++i) {
        const auto [x, y] = factors[static_cast<std::size_t>(i)];
        switch (random() % 3) {
            case 0: times(x, y), times(x, y); break;
            case 1: times(x * x + y * y, 0); break;
            default: times(x, -y), times(x, -y); break;
        }
    }
    for (std::uint64_t turns = random() % 4; turns > 0; --turns) times(0, 1);
    return {z.real(), z.imag()};
}

inline void scale(Point& p, int exponent) {
    for (double& x : p) x = std::ldexp(x, exponent);
}

inline Point subnormal_point(Random& random, int bits) {
    Point p;
    for (double& x : p)
        x = (random() % 2 == 0 ? 1.0 : -1.0) * std::ldexp(static_cast<double>(random() >> (64 - bits)), -1074);
    return p;
}

/// A line's direction: along an axis, of small slope, or any.
inline Point direction(Random& random) {
    switch (random() % 4) {
        case 0: return {1, 0};
        case 1: return {0, 1};
        case 2: return {static_cast<double>(integer(random, 1, 7)), static_cast<double>(integer(random, -7, 7))};
        default: return on_circle(between(random, 0, 6.28), 1, {0, 0});
    }
}

inline Bicell rotated(const Bicell& c, double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto turn = [=](const Point& p) { return Point{cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1]}; };
    return {turn(c.a), turn(c.b), turn(c.p), turn(c.q)};
}

}  // namespace annulus::testing
