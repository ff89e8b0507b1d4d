// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace annulus::testing {

std::string_view name_of(Triangle_family family) {
    switch (family) {
        case Triangle_family::uniform: return "uniform";
        case Triangle_family::grid: return "grid";
        case Triangle_family::noisy_grid: return "noisy grid";
        case Triangle_family::collinear: return "collinear";
        case Triangle_family::nearly_collinear: return "nearly collinear";
        case Triangle_family::sliver: return "sliver";
        case Triangle_family::needle: return "needle";
        case Triangle_family::tiny: return "tiny";
        case Triangle_family::subnormal: return "subnormal";
        case Triangle_family::huge: return "huge";
        case Triangle_family::far_offset: return "far offset";
        case Triangle_family::mixed_scales: return "mixed scales";
    }
    return "?";
}

Triangle triangle(Triangle_family family, Random& random) {
    const auto small = [&random](int most) {
        return Point{static_cast<double>(integer(random, 0, most)), static_cast<double>(integer(random, 0, most))};
    };
    const auto flat = [&random](double altitude, double side) {
        const double angle = random() % 2 == 0 ? 0.0 : between(random, 0, 6.28);
        const Bicell c = rotated({{0, 0}, {side, 0}, {between(random, -1, 2), altitude}, {0, 0}}, angle);
        return Triangle{c.a, c.b, c.p};
    };
    const double sign = random() % 2 == 0 ? 1.0 : -1.0;
    switch (family) {
        case Triangle_family::uniform: return {uniform_point(random), uniform_point(random), uniform_point(random)};
        case Triangle_family::grid: {
            const int most = integer(random, 1, 8);
            return {small(most), small(most), small(most)};
        }
        case Triangle_family::noisy_grid: {
            const auto noisy = [&] {
                const Point p = small(5);
                return Point{ulp_noise(random, 1 + p[0], 2), ulp_noise(random, 1 + p[1], 2)};
            };
            return {noisy(), noisy(), noisy()};
        }
        case Triangle_family::collinear: {
            const Point start = small(20);
            const Point step{static_cast<double>(integer(random, -9, 9)), static_cast<double>(integer(random, -9, 9))};
            const auto on_line = [&] {
                const double t = integer(random, -50, 50);
                return Point{start[0] + t * step[0], start[1] + t * step[1]};
            };
            return {on_line(), on_line(), on_line()};
        }
        case Triangle_family::nearly_collinear: {
            const Point along = direction(random);
            const Point start = uniform_point(random);
            const auto near_line = [&] {
                const double t = between(random, -2, 2);
                return Point{ulp_noise(random, start[0] + t * along[0], 1),
                             ulp_noise(random, start[1] + t * along[1], 1)};
            };
            return {near_line(), near_line(), near_line()};
        }
        case Triangle_family::sliver:
            return flat(sign * std::ldexp(between(random, 1, 2), -integer(random, 10, 52)), 1);
        case Triangle_family::needle: return flat(sign * unit(random), std::ldexp(1.0, -integer(random, 10, 50)));
        case Triangle_family::tiny:
        case Triangle_family::huge: {
            if (family == Triangle_family::huge && random() % 4 == 0) {
                const auto corner = [&random] {
                    const std::array<double, 3> ends{0.0, 0x1p500, -0x1p500};
                    return Point{ends[random() % 3], ends[random() % 3]};
                };
                return {corner(), corner(), corner()};
            }
            Triangle t = random() % 2 == 0 ? triangle(Triangle_family::uniform, random)
                                           : triangle(Triangle_family::sliver, random);
            const int exponent =
                family == Triangle_family::tiny ? integer(random, -420, -380) : integer(random, 380, 498);
            for (Point* p : {&t.a, &t.b, &t.c}) scale(*p, exponent);
            return t;
        }
        case Triangle_family::subnormal: {
            const int bits = integer(random, 2, 52);
            return {subnormal_point(random, bits), subnormal_point(random, bits), subnormal_point(random, bits)};
        }
        case Triangle_family::far_offset: {
            const Point offset{sign * 0x1p40, random() % 2 == 0 ? 0x1p40 : 0.0};
            const auto moved = [&] {
                const Point p = small(20);
                return Point{offset[0] + p[0], offset[1] + p[1]};
            };
            return {moved(), moved(), moved()};
        }
        case Triangle_family::mixed_scales: {
            const auto any = [&random] { return Point{any_in_domain(random), any_in_domain(random)}; };
            return {any(), any(), any()};
        }
    }
    throw std::logic_error("no triangle of this family");
}

}  // namespace annulus::testing
