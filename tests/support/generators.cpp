// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <optional>
#include <set>
#include <stdexcept>

namespace annulus::testing {

// ---- Numbers ----------------------------------------------------------------------------------------------------

double unit(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

double between(Random& random, double low, double high) { return low + (high - low) * unit(random); }

int integer(Random& random, int low, int high) {
    const auto range = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(random() % range));
}

double ulp_noise(Random& random, double x, int ulps) {
    for (int k = integer(random, -ulps, ulps); k != 0; k += k > 0 ? -1 : 1)
        x = std::nextafter(x, k > 0 ? HUGE_VAL : -HUGE_VAL);
    return x;
}

double any_in_domain(Random& random) {
    const double sign = random() % 2 == 0 ? 1.0 : -1.0;
    switch (random() % 8) {
        case 0: return random() % 2 == 0 ? sign * 0.0 : sign * 0x1p500;
        case 1: return sign * std::ldexp(1.0, integer(random, -1074, 500));
        case 2: return sign * std::ldexp(unit(random), -1022);
        default: return sign * std::ldexp(0.5 + 0.5 * unit(random), integer(random, -1073, 500));
    }
}

// ---- Exact signs ------------------------------------------------------------------------------------------------

int exact_orientation(const Point& a, const Point& b, const Point& c) {
    const mpq_class ax(a[0]), ay(a[1]), bx(b[0]), by(b[1]), cx(c[0]), cy(c[1]);
    const mpq_class left = (bx - ax) * (cy - ay);
    const mpq_class right = (by - ay) * (cx - ax);
    return (left > right) - (left < right);
}

int exact_empty_circle(const Point& a, const Point& b, const Point& q, const Point& p) {
    // The 3 x 3 determinant of the lifted points with p as the origin, expanded along the column of squares.
    const auto row = [&p](const Point& x) {
        const mpq_class dx = mpq_class(x[0]) - mpq_class(p[0]);
        const mpq_class dy = mpq_class(x[1]) - mpq_class(p[1]);
        const mpq_class lift = dx * dx + dy * dy;
        return std::array<mpq_class, 3>{dx, dy, lift};
    };
    const auto i = row(a), j = row(b), k = row(q);
    const mpq_class inside =
        i[2] * (j[0] * k[1] - j[1] * k[0]) - j[2] * (i[0] * k[1] - i[1] * k[0]) + k[2] * (i[0] * j[1] - i[1] * j[0]);
    return -sgn(inside);
}

// ---- Parts shared by the families -------------------------------------------------------------------------------

namespace {

Point on_circle(double angle, double radius, const Point& centre) {
    return {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle)};
}

Point uniform_point(Random& random) { return {between(random, -1, 1), between(random, -1, 1)}; }

/// Integer points on the circle of radius 5 * 13 * 17 * ... (`primes` factors) around 0: a random one of the
/// 4 * 3^primes. Each prime is a Gaussian norm, and its square splits in three ways.
Point pythagorean(Random& random, int primes) {
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

void scale(Point& p, int exponent) {
    for (double& x : p) x = std::ldexp(x, exponent);
}

Point subnormal_point(Random& random, int bits) {
    Point p;
    for (double& x : p)
        x = (random() % 2 == 0 ? 1.0 : -1.0) * std::ldexp(static_cast<double>(random() >> (64 - bits)), -1074);
    return p;
}

/// A line's direction: along an axis, of small slope, or any.
Point direction(Random& random) {
    switch (random() % 4) {
        case 0: return {1, 0};
        case 1: return {0, 1};
        case 2: return {static_cast<double>(integer(random, 1, 7)), static_cast<double>(integer(random, -7, 7))};
        default: return on_circle(between(random, 0, 6.28), 1, {0, 0});
    }
}

}  // namespace

// ---- Point sets -------------------------------------------------------------------------------------------------

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

// ---- Bi-cells ---------------------------------------------------------------------------------------------------

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

Bicell rotated(const Bicell& c, double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const auto turn = [=](const Point& p) { return Point{cosine * p[0] - sine * p[1], sine * p[0] + cosine * p[1]}; };
    return {turn(c.a), turn(c.b), turn(c.p), turn(c.q)};
}

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

// ---- Triangles --------------------------------------------------------------------------------------------------

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

// ---- Cases as code ----------------------------------------------------------------------------------------------

std::string as_code(double x) {
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%a", x);
    return text.data();
}

std::string as_code(const Point& p) { return "{" + as_code(p[0]) + ", " + as_code(p[1]) + "}"; }

std::string as_code(const Points& points) {
    std::string text = "const std::vector<annulus::Coordinates<2>> points{";
    for (const Point& p : points) text += "\n    " + as_code(p) + ",";
    return text + "};";
}

std::string as_code(const Bicell& c) {
    return "const annulus::testing::Bicell x{" + as_code(c.a) + ", " + as_code(c.b) + ", " + as_code(c.p) + ", " +
           as_code(c.q) + "};";
}

std::string as_code(const Triangle& t) {
    return "const annulus::testing::Triangle x{" + as_code(t.a) + ", " + as_code(t.b) + ", " + as_code(t.c) + "};";
}

}  // namespace annulus::testing
