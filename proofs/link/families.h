// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace annulus::link {

/// Numbers from a counter (SplitMix64); the same everywhere, other than the distributions of <random>. Draws are
/// never two arguments of one call: their order would be the compiler's.
class Source {
  public:
    explicit Source(std::uint64_t seed) : state_(seed * 0x9e3779b97f4a7c15u) {}
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int integer(int low, int high) {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    /// In [-1, 1], 53 bits.
    double uniform() { return static_cast<double>(static_cast<std::int64_t>(bits() >> 10) - (1LL << 53)) * 0x1p-53; }

  private:
    std::uint64_t state_;
};

/// x a few units in the last place up or down.
inline double nudged(double x, int ulps) {
    const double to = ulps > 0 ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
    for (int i = ulps < 0 ? -ulps : ulps; i > 0; --i) x = std::nextafter(x, to);
    return x;
}

/// A point of the unit circle from the rational parametrisation; rounded, so off the circle by an ulp or so.
inline Coordinates<2> on_circle(double t) {
    const double q = 1.0 + t * t;
    return {(1.0 - t * t) / q, 2.0 * t / q};
}

constexpr int families = 10;

/// The i-th case: a, b, p, q. In most families p is right of ab and q left of it, so that not all answers are negative.
inline std::array<Coordinates<2>, 4> bicell_2(std::size_t i) {
    Source s(i + 1);
    std::array<Coordinates<2>, 4> x{};
    const auto any = [&] { return Coordinates<2>{s.uniform(), s.uniform()}; };
    const auto convex = [&] {  // a, b, p below, q above
        const double far = std::ldexp(1.0, -s.integer(0, 20));
        return std::array<Coordinates<2>, 4>{
            Coordinates<2>{s.uniform() * 0.1, s.uniform() * 0.1},
            Coordinates<2>{1.0 + s.uniform() * 0.1, s.uniform() * 0.1},
            Coordinates<2>{0.5 + 0.5 * s.uniform(), -0.2 - far - std::fabs(s.uniform())},
            Coordinates<2>{0.5 + 0.5 * s.uniform(), 0.2 + far + std::fabs(s.uniform())}};
    };
    switch (static_cast<int>(i % families)) {
        case 0:  // anything
            for (auto& p : x) p = any();
            break;
        case 1:  // a bi-cell of no special shape
            x = convex();
            break;
        case 2: {  // cocircular to the ulp, in the order a p b q
            const double t = 0.5 * s.uniform();
            x = {on_circle(t), on_circle(t + 1.0), on_circle(t + 0.4), on_circle(t + 3.0)};
            const int most = s.integer(0, 1) ? 2 : 1 << s.integer(2, 20);
            for (auto& p : x)
                for (double& c : p)
                    c = most <= 16 ? nudged(c, s.integer(-most, most)) : c + 0x1p-52 * s.integer(-most, most);
            break;
        }
        case 3:  // a small grid: exactly cocircular and collinear ones
            for (auto& p : x) p = {static_cast<double>(s.integer(-2, 2)), static_cast<double>(s.integer(-2, 2))};
            break;
        case 4: {  // slivers: p and q near the line ab
            const double flat = std::ldexp(1.0, -s.integer(3, 55));
            x = {any(), any(), any(), any()};
            x[1] = {x[0][0] + 1.0, x[0][1]};
            x[2] = {x[0][0] + std::fabs(s.uniform()), x[0][1] - flat * std::fabs(s.uniform())};
            x[3] = {x[0][0] + std::fabs(s.uniform()), x[0][1] + flat * std::fabs(s.uniform())};
            break;
        }
        case 5: {  // within the range of the filter, at both ends and beyond
            const double scale = std::ldexp(1.0, s.integer(-124, 122));
            x = convex();
            for (auto& p : x)
                for (double& c : p) c *= scale;
            break;
        }
        case 6: {  // far from the origin
            const double far = std::ldexp(1.0, s.integer(5, 50));
            x = convex();
            for (auto& p : x) p = {p[0] + far, p[1] - far};
            break;
        }
        case 7: {  // theta near 0: pq nearly parallel to ab
            const double flat = std::ldexp(1.0, -s.integer(2, 40));
            x[0] = {0.0, 0.0};
            x[1] = {1.0, 0x1p-10 * s.uniform()};
            x[2] = {-1.0 + s.uniform() * 0.25, -flat * std::fabs(s.uniform())};
            x[3] = {2.0 + s.uniform() * 0.25, flat * std::fabs(s.uniform())};
            break;
        }
        case 8: {  // every scale by itself, zeros, subnormal numbers, the ends of the coordinate domain
            for (auto& p : x)
                for (double& c : p) {
                    const int exponent = s.integer(0, 3) ? s.integer(-60, 60) : s.integer(-1074, 499);
                    c = s.integer(0, 5) == 0 ? 0.0 : std::ldexp(s.uniform(), exponent);
                }
            break;
        }
        default: {  // where the answers of the filter begin: an almost cocircular one with a chosen deficit
            const double t = 0.5 * s.uniform();
            x = {on_circle(t), on_circle(t + 1.0), on_circle(t + 0.4), on_circle(t + 3.0)};
            const int exponent = -s.integer(30, 46);
            const double grow = 1.0 + std::ldexp(s.uniform(), exponent);
            for (double& c : x[2]) c *= grow;
            break;
        }
    }
    return x;
}

/// A point of the unit sphere, stereographic; rounded.
inline Coordinates<3> on_sphere(double s, double t) {
    const double q = 1.0 + (s * s + t * t);
    return {2.0 * s / q, 2.0 * t / q, (s * s + t * t - 1.0) / q};
}

/// The i-th case in space: a, b, c, p, q. In most families q is in front of the facet a b c and p behind it.
inline std::array<Coordinates<3>, 5> bicell_3(std::size_t i) {
    Source s(i + 1000001);
    std::array<Coordinates<3>, 5> x{};
    const auto any = [&] { return Coordinates<3>{s.uniform(), s.uniform(), s.uniform()}; };
    const auto convex = [&] {  // a b c near the plane z = 0, p below, q above
        std::array<Coordinates<3>, 5> y{Coordinates<3>{0.0, 0.0, 0.0}, Coordinates<3>{1.0, 0.0, 0.0},
                                        Coordinates<3>{0.0, 1.0, 0.0}, Coordinates<3>{0.4, 0.3, -0.6},
                                        Coordinates<3>{0.3, 0.4, 0.6}};
        const double far = 0.25 * (1 + s.integer(0, 3));
        for (auto& p : y)
            for (double& c : p) c += 0.2 * s.uniform();
        y[3][2] -= far;
        y[4][2] += far;
        return y;
    };
    switch (static_cast<int>(i % families)) {
        case 0:  // anything
            for (auto& p : x) p = any();
            break;
        case 1: x = convex(); break;
        case 2:
        case 9: {  // cospherical to the ulp; or almost, with a chosen deficit
            for (auto& p : x) {
                const double u = s.uniform();
                const double v = s.uniform();
                p = on_sphere(u, v);
            }
            if (i % families == 9) {
                const int exponent = -s.integer(28, 46);
                const double grow = 1.0 + std::ldexp(s.uniform(), exponent);
                for (double& c : x[4]) c *= grow;
            }
            break;
        }
        case 3:  // a small grid
            for (auto& p : x)
                for (double& c : p) c = static_cast<double>(s.integer(-1, 1));
            break;
        case 4: {  // slivers: p and q near the plane
            const double flat = std::ldexp(1.0, -s.integer(3, 55));
            x = convex();
            for (auto& p : x) p[2] *= flat;
            break;
        }
        case 5: {  // within the range of the filter, at both ends and beyond
            const double scale = std::ldexp(1.0, s.integer(-104, 102));
            x = convex();
            for (auto& p : x)
                for (double& c : p) c *= scale;
            break;
        }
        case 6: {  // far from the origin
            const double far = std::ldexp(1.0, s.integer(5, 50));
            x = convex();
            for (auto& p : x) p = {p[0] + far, p[1] - far, p[2] + 0.5 * far};
            break;
        }
        case 7: {  // three cells around an edge: p q passes outside the facet, other partitions decide
            const double pole = 1.0 - std::ldexp(1.0, -s.integer(2, 30));
            x = {Coordinates<3>{0.0, 0.0, pole}, Coordinates<3>{0.0, 0.0, -pole}, Coordinates<3>{1.0, 0.0, 0.0},
                 Coordinates<3>{-0.5, 0.875, 0.0}, Coordinates<3>{-0.5, -0.875, 0.0}};
            for (auto& p : x)
                for (double& c : p) c += 0x1p-40 * s.uniform();
            break;
        }
        default: {  // every scale by itself
            for (auto& p : x)
                for (double& c : p) {
                    const int exponent = s.integer(0, 3) ? s.integer(-60, 60) : s.integer(-1074, 499);
                    c = s.integer(0, 5) == 0 ? 0.0 : std::ldexp(s.uniform(), exponent);
                }
            break;
        }
    }
    return x;
}

}  // namespace annulus::link
