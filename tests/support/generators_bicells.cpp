// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace annulus::testing {

std::string_view name_of(Bicell_family family) {
    switch (family) {
        case Bicell_family::uniform: return "uniform";
        case Bicell_family::grid: return "grid";
        case Bicell_family::noisy_grid: return "noisy grid";
        case Bicell_family::cocircular_rounded: return "cocircular, rounded";
        case Bicell_family::cocircular_near: return "cocircular, near";
        case Bicell_family::cocircular_exact: return "cocircular, exact";
        case Bicell_family::theta_zero: return "theta -> 0";
        case Bicell_family::sliver: return "sliver";
        case Bicell_family::needle: return "needle";
        case Bicell_family::non_convex: return "non-convex";
        case Bicell_family::nearly_collinear: return "nearly collinear";
        case Bicell_family::tiny: return "tiny";
        case Bicell_family::subnormal: return "subnormal";
        case Bicell_family::huge: return "huge";
        case Bicell_family::far_offset: return "far offset";
        case Bicell_family::mixed_scales: return "mixed scales";
    }
    return "?";
}

bool is_bicell(const Bicell& c) { return exact_orientation(c.a, c.b, c.q) > 0 && exact_orientation(c.b, c.a, c.p) > 0; }

namespace {

/// Four points as a bi-cell: an edge (chosen at random) that has the other two on opposite sides.
std::optional<Bicell> arranged(std::array<Point, 4> x, Random& random) {
    for (std::size_t i = 4; i > 1; --i) std::swap(x[i - 1], x[random() % i]);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            std::array<Point, 2> rest;
            for (std::size_t k = 0, r = 0; k < 4; ++k)
                if (k != i && k != j) rest[r++] = x[k];
            for (const Bicell& c : {Bicell{x[i], x[j], rest[0], rest[1]}, Bicell{x[i], x[j], rest[1], rest[0]}})
                if (is_bicell(c)) return c;
        }
    return std::nullopt;
}

template <class Make>
std::optional<Bicell> arranged_four(Random& random, Make make) {
    std::array<Point, 4> x;
    for (Point& p : x) p = make();
    return arranged(x, random);
}

std::optional<Bicell> checked(const Bicell& c) { return is_bicell(c) ? std::optional(c) : std::nullopt; }

std::optional<Bicell> attempt(Bicell_family family, Random& random) {
    const auto small = [&random](int most) {
        return Point{static_cast<double>(integer(random, 0, most)), static_cast<double>(integer(random, 0, most))};
    };
    switch (family) {
        case Bicell_family::uniform: return arranged_four(random, [&] { return uniform_point(random); });
        case Bicell_family::grid: {
            const int most = integer(random, 1, 8);
            return arranged_four(random, [&] { return small(most); });
        }
        case Bicell_family::noisy_grid: {
            const int ulps = integer(random, 1, 4);
            const double stretch = random() % 2 == 0 ? 1.0 : integer(random, 1, 9);
            const auto x = [&](double i) { return ulp_noise(random, 1 + i, ulps); };
            const auto y = [&](double i) { return ulp_noise(random, 1 + stretch * i, ulps); };
            return checked({{x(0), y(0)}, {x(1), y(1)}, {x(1), y(0)}, {x(0), y(1)}});
        }
        case Bicell_family::cocircular_rounded:
        case Bicell_family::cocircular_near: {
            const double radius = std::ldexp(between(random, 1, 2), integer(random, -3, 10));
            const Point centre = random() % 2 == 0 ? Point{0, 0} : uniform_point(random);
            const double first = between(random, 0, 6.28);
            const double arc = std::ldexp(6.28, -integer(random, 0, 8));  // the smaller, the flatter
            const double off =
                family == Bicell_family::cocircular_near ? std::ldexp(1.0, -integer(random, 10, 52)) : 0.0;
            return arranged_four(random, [&] {
                return on_circle(first + arc * unit(random), radius * (1 + off * between(random, -1, 1)), centre);
            });
        }
        case Bicell_family::cocircular_exact: {
            const int primes = integer(random, 1, 5);
            const double k = integer(random, 1, 9);
            const int exponent = integer(random, -20, 20);
            const Point centre = small(50);
            return arranged_four(random, [&] {
                const Point p = pythagorean(random, primes);
                Point moved{centre[0] + k * p[0], centre[1] + k * p[1]};
                scale(moved, exponent);
                return moved;
            });
        }
        case Bicell_family::theta_zero: {
            const double flat = std::ldexp(1.0, -integer(random, 4, 60));
            // Half of them with the midpoints of a b and p q together: then N and M of the width formula are small too.
            const double x = between(random, -1, 2);
            const double y = random() % 2 == 0 ? between(random, -1, 2) : ulp_noise(random, 1 - x, 2);
            const Bicell c{{0, 0}, {1, 0}, {x, -flat * unit(random)}, {y, flat * unit(random)}};
            return checked(random() % 2 == 0 ? c : rotated(c, between(random, 0, 6.28)));
        }
        case Bicell_family::sliver: {
            const double flat = std::ldexp(1.0, -integer(random, 10, 50));
            const auto c = arranged_four(random, [&] {
                const Point p = uniform_point(random);
                return Point{p[0], flat * p[1]};
            });
            if (!c || random() % 2 == 0) return c;
            return checked(rotated(*c, between(random, 0, 6.28)));
        }
        case Bicell_family::needle: {
            const double length = std::ldexp(1.0, -integer(random, 1, 50));
            const double angle = between(random, 0, 6.28);
            const Point tip = uniform_point(random);
            const std::array<Point, 4> x{tip, on_circle(angle, length, tip), uniform_point(random),
                                         uniform_point(random)};
            if (random() % 2 == 0) return arranged(x, random);
            return checked({x[0], x[1], on_circle(angle - between(random, 0, 3.14), 1, tip),
                            on_circle(angle + between(random, 0, 3.14), 1, tip)});
        }
        case Bicell_family::non_convex: {
            const Point b = uniform_point(random), p = uniform_point(random), q = uniform_point(random);
            const double i = unit(random) * std::ldexp(1.0, -integer(random, 0, 40) * integer(random, 0, 1));
            const double j = unit(random) * (1 - i);
            const double k = 1 - i - j;
            const Point a{i * b[0] + j * p[0] + k * q[0], i * b[1] + j * p[1] + k * q[1]};
            if (exact_orientation(b, q, p) <= 0 || exact_orientation(a, q, p) <= 0) return std::nullopt;
            return checked(random() % 2 == 0 ? Bicell{a, b, p, q} : Bicell{b, a, q, p});
        }
        case Bicell_family::nearly_collinear: {
            const Point along = direction(random);
            const Point start = random() % 2 == 0 ? Point{0, 0} : uniform_point(random);
            const int ulps = integer(random, 1, 3);
            const bool all = random() % 2 == 0;
            int made = 0;
            return arranged_four(random, [&] {
                if (!all && made++ == 0) return uniform_point(random);
                const double t = between(random, -2, 2);
                return Point{ulp_noise(random, start[0] + t * along[0], ulps),
                             ulp_noise(random, start[1] + t * along[1], ulps)};
            });
        }
        case Bicell_family::tiny:
        case Bicell_family::huge: {
            static constexpr std::array bases{Bicell_family::uniform, Bicell_family::grid,
                                              Bicell_family::cocircular_near, Bicell_family::sliver};
            if (family == Bicell_family::huge && random() % 4 == 0) {
                const std::array<double, 5> ends{0.0, 0x1p500, -0x1p500, std::nextafter(0x1p500, 0.0), -0.0};
                return arranged_four(random, [&] { return Point{ends[random() % 5], ends[random() % 5]}; });
            }
            auto c = attempt(bases[random() % bases.size()], random);
            if (!c) return c;
            double largest = 0;
            for (const Point* p : c->tuple()) largest = std::max({largest, std::fabs((*p)[0]), std::fabs((*p)[1])});
            const int magnitude =
                family == Bicell_family::tiny ? integer(random, -420, -380) : integer(random, 380, 500);
            const int exponent = magnitude - std::ilogb(largest) - 1;
            for (Point* p : {&c->a, &c->b, &c->p, &c->q}) scale(*p, exponent);
            return c;
        }
        case Bicell_family::subnormal: {
            const int bits = integer(random, 2, 52);
            return arranged_four(random, [&] { return subnormal_point(random, bits); });
        }
        case Bicell_family::far_offset: {
            const Point offset{random() % 2 == 0 ? 0x1p40 : -0x1p40, random() % 2 == 0 ? 0x1p40 : 0.0};
            const int most = integer(random, 1, 20);
            return arranged_four(random, [&] {
                const Point p = small(most);
                return Point{offset[0] + p[0], offset[1] + p[1]};
            });
        }
        case Bicell_family::mixed_scales:
            return arranged_four(random, [&] { return Point{any_in_domain(random), any_in_domain(random)}; });
    }
    return std::nullopt;
}

}  // namespace

Bicell bicell(Bicell_family family, Random& random) {
    for (int tries = 0; tries < 10000; ++tries)
        if (const auto c = attempt(family, random)) return *c;
    throw std::logic_error("no bi-cell of this family");
}

Bicell delaunay_bicell(Bicell_family family, Random& random) {
    // A circle that is not empty means convex position, where the other diagonal is the right one.
    const Bicell c = bicell(family, random);
    return exact_empty_circle(c.a, c.b, c.q, c.p) >= 0 ? c : c.flipped();
}

}  // namespace annulus::testing
