// SPDX-License-Identifier: GPL-3.0-or-later
#include "generator_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <stdexcept>

namespace annulus::testing {

std::string_view name_of(Family family) {
    switch (family) {
        case Family::uniform: return "uniform";
        case Family::grid: return "grid";
        case Family::noisy_grid: return "noisy grid";
        case Family::cocircular_rounded: return "cocircular, rounded";
        case Family::cocircular_exact: return "cocircular, exact";
        case Family::cocircular_near: return "cocircular, near";
        case Family::collinear: return "collinear";
        case Family::nearly_collinear: return "nearly collinear";
        case Family::clustered: return "clustered";
        case Family::tiny: return "tiny";
        case Family::subnormal: return "subnormal";
        case Family::huge: return "huge";
        case Family::far_offset: return "far offset";
        case Family::mixture: return "mixture";
    }
    return "?";
}

namespace {

/// Collects distinct points until there are enough; a family too poor for n of them is an error of the generator.
template <class Make>
Points distinct(std::size_t n, Make make) {
    std::set<Point> seen;
    Points points;
    for (std::size_t tries = 0; points.size() < n; ++tries) {
        if (tries > 100 * n + 1000) throw std::logic_error("the family has not that many distinct points");
        const Point p = make(points.size());
        if (seen.insert(p).second) points.push_back(p);
    }
    return points;
}

Points distinct_points(Family family, std::size_t n, Random& random) {
    const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
    const auto cell = [side](std::size_t i) {
        return Point{static_cast<double>(i % side), static_cast<double>(i / side)};
    };
    switch (family) {
        case Family::uniform: return distinct(n, [&](std::size_t) { return uniform_point(random); });
        case Family::grid: return distinct(n, cell);
        case Family::noisy_grid: {
            const int ulps = integer(random, 1, 4);
            return distinct(n, [&](std::size_t i) {
                // From 1 on: an ulp of 0 is no noise at all.
                const Point c = cell(i);
                return Point{ulp_noise(random, c[0] + 1, ulps), ulp_noise(random, c[1] + 1, ulps)};
            });
        }
        case Family::cocircular_rounded: {
            const double radius = std::ldexp(between(random, 1, 2), integer(random, -3, 10));
            const Point centre = random() % 2 == 0 ? Point{0, 0} : uniform_point(random);
            const bool regular = random() % 2 == 0;
            return distinct(n, [&](std::size_t i) {
                const double turn = regular ? static_cast<double>(i) / static_cast<double>(n) : unit(random);
                return on_circle(2 * std::numbers::pi * turn, radius, centre);
            });
        }
        case Family::cocircular_exact: {
            // Fewer points than 4 * 3^k on a circle or up to three of them.
            const int circles = integer(random, 1, 3);
            int primes = 2;
            for (std::size_t room = 36; room < 2 * n && primes < 7; room *= 3) ++primes;
            const Point centre{static_cast<double>(integer(random, -99, 99)),
                               static_cast<double>(integer(random, -99, 99))};
            return distinct(n, [&](std::size_t) {
                const Point p = pythagorean(random, primes);
                const double k = integer(random, 1, circles);
                return Point{centre[0] + k * p[0], centre[1] + k * p[1]};
            });
        }
        case Family::cocircular_near: {
            const double radius = std::ldexp(between(random, 1, 2), integer(random, -3, 10));
            const Point centre = random() % 2 == 0 ? Point{0, 0} : uniform_point(random);
            const double arc = std::ldexp(6.28, -integer(random, 0, 4));  // the smaller, the flatter
            const int off = integer(random, 10, 40);
            const bool alike = random() % 2 == 0;  // or each off by another power
            return distinct(n, [&](std::size_t) {
                const int by = alike ? off : integer(random, 10, 40);
                return on_circle(arc * unit(random), radius * (1 + std::ldexp(between(random, -1, 1), -by)), centre);
            });
        }
        case Family::collinear: {
            const Point step{static_cast<double>(integer(random, 0, 5)), static_cast<double>(integer(random, 1, 5))};
            const Point start{static_cast<double>(integer(random, -9, 9)), static_cast<double>(integer(random, -9, 9))};
            return distinct(n, [&](std::size_t) {
                const double t = integer(random, -4 * static_cast<int>(n), 4 * static_cast<int>(n));
                return Point{start[0] + t * step[0], start[1] + t * step[1]};
            });
        }
        case Family::nearly_collinear: {
            const Point along = direction(random);
            const Point start = uniform_point(random);
            const int ulps = integer(random, 0, 3);
            return distinct(n, [&](std::size_t) {
                const double t = between(random, -2, 2);
                return Point{ulp_noise(random, start[0] + t * along[0], ulps),
                             ulp_noise(random, start[1] + t * along[1], ulps)};
            });
        }
        case Family::clustered:
            return distinct(n, [&, seed = random()](std::size_t) {
                // The path to a point through three levels of eight clusters each; a cluster's place is a hash.
                Point p{0, 0};
                std::uint64_t key = seed;
                for (const int level : {0, 10, 20}) {
                    key = key * 8 + random() % 8 + 1;
                    Random place(key);
                    const Point offset = uniform_point(place);
                    p[0] += std::ldexp(offset[0], -level);
                    p[1] += std::ldexp(offset[1], -level);
                }
                const Point offset = uniform_point(random);
                return Point{p[0] + std::ldexp(offset[0], -30), p[1] + std::ldexp(offset[1], -30)};
            });
        case Family::tiny: {
            const int exponent = integer(random, -420, -380);
            return distinct(n, [&](std::size_t) {
                Point p = uniform_point(random);
                scale(p, exponent);
                return p;
            });
        }
        case Family::subnormal: {
            const int bits = integer(random, std::max(4, static_cast<int>(std::log2(side + 1)) + 2), 52);
            return distinct(n, [&](std::size_t) { return subnormal_point(random, bits); });
        }
        case Family::huge: {
            const int exponent = integer(random, 400, 500);
            return distinct(n, [&](std::size_t i) {
                Point p = i < 4 ? Point{i % 2 == 0 ? -1.0 : 1.0, i < 2 ? -1.0 : 1.0} : uniform_point(random);
                scale(p, exponent);
                return p;
            });
        }
        case Family::far_offset: {
            const Point offset{random() % 2 == 0 ? 0x1p40 : -0x1p40, random() % 2 == 0 ? 0x1p40 : -0x1p40};
            return distinct(n, [&](std::size_t) {
                const int reach = static_cast<int>(2 * side);
                return Point{offset[0] + integer(random, 0, reach), offset[1] + integer(random, 0, reach)};
            });
        }
        case Family::mixture: break;
    }
    // Parts that overlap in 3D: each comes from its family as it is, or brought to the unit square.
    const std::size_t parts = 2 + random() % 2;
    Points pool;
    for (std::size_t i = 0; i < parts; ++i) {
        Points part = distinct_points(all_families[random() % (all_families.size() - 1)], n, random);
        if (random() % 2 == 0) {
            double largest = 0;
            for (const Point& p : part) largest = std::max({largest, std::fabs(p[0]), std::fabs(p[1])});
            const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
            for (Point& p : part) scale(p, exponent);
        }
        pool.insert(pool.end(), part.begin(), part.end());
    }
    return distinct(n, [&](std::size_t) { return pool[random() % pool.size()]; });
}

void shuffle(Points& points, Random& random) {
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random() % i]);
}

}  // namespace

Points point_set(Family family, std::size_t n, Random& random, bool duplicates) {
    Points points = distinct_points(family, n, random);
    shuffle(points, random);
    if (duplicates)
        for (std::size_t i = 3; i < points.size(); ++i)
            if (random() % 5 == 0) points[i] = points[random() % i];
    return points;
}

}  // namespace annulus::testing
