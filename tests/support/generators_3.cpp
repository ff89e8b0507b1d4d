// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators_3.h"

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace annulus::testing {

namespace {

using Rational_3 = std::array<mpq_class, 3>;

Rational_3 from(const Point_3& origin, const Point_3& p) {
    Rational_3 v;
    for (std::size_t k = 0; k < 3; ++k) v[k] = mpq_class(p[k]) - mpq_class(origin[k]);
    return v;
}
mpq_class determinant(const Rational_3& u, const Rational_3& v, const Rational_3& w) {
    return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
}
mpq_class norm(const Rational_3& u) { return u[0] * u[0] + u[1] * u[1] + u[2] * u[2]; }

}  // namespace

int exact_orientation(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d) {
    return sgn(determinant(from(a, b), from(a, c), from(a, d)));
}

int exact_empty_sphere(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d, const Point_3& e) {
    // The 4 x 4 determinant of the lifted points with e as the origin, expanded along the column of squares.
    const std::array<Rational_3, 4> x{from(e, a), from(e, b), from(e, c), from(e, d)};
    const mpq_class inside = norm(x[0]) * determinant(x[1], x[2], x[3]) - norm(x[1]) * determinant(x[0], x[2], x[3]) +
                             norm(x[2]) * determinant(x[0], x[1], x[3]) - norm(x[3]) * determinant(x[0], x[1], x[2]);
    return -sgn(inside);
}

namespace {

using Five = std::array<Point_3, 5>;

Point_3 uniform_point(Random& random) {
    return {between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
}

Point_3 unit_vector(Random& random) {
    for (;;) {
        Point_3 p = uniform_point(random);
        const double length = std::hypot(p[0], p[1], p[2]);
        if (length < 0.1 || length > 1) continue;
        for (double& x : p) x /= length;
        return p;
    }
}

Point_3 small(Random& random, int most) {
    Point_3 p;
    for (double& x : p) x = integer(random, 0, most);
    return p;
}

/// Turns all points about two axes, or not at all.
void turn(Five& x, Random& random) {
    if (random() % 2 == 0) return;
    for (const std::size_t axis : {0U, 2U}) {
        const double angle = between(random, 0, 6.28), cosine = std::cos(angle), sine = std::sin(angle);
        for (Point_3& p : x) {
            double& i = p[(axis + 1) % 3];
            double& j = p[(axis + 2) % 3];
            const double turned = cosine * i - sine * j;
            j = sine * i + cosine * j;
            i = turned;
        }
    }
}

/// Five points of the family in no particular order; if the family concerns an edge or a facet, `facet` is set, and x =
/// a, b, c, p, q up to the orientation.
Five five(Family_3 family, Random& random) {
    Five x{};
    const auto each = [&x](auto make) {
        for (Point_3& p : x) p = make();
    };
    switch (family) {
        case Family_3::uniform: each([&] { return uniform_point(random); }); break;
        case Family_3::grid: {
            const int most = integer(random, 1, 6);
            each([&] { return small(random, most); });
            break;
        }
        case Family_3::noisy_grid: {
            const int ulps = integer(random, 1, 4), most = integer(random, 1, 3);
            each([&] {
                Point_3 p = small(random, most);
                for (double& c : p) c = ulp_noise(random, 1 + c, ulps);
                return p;
            });
            break;
        }
        case Family_3::cospherical_rounded:
        case Family_3::cospherical_near: {
            const double radius = std::ldexp(between(random, 1, 2), integer(random, -3, 10));
            const Point_3 centre = random() % 2 == 0 ? Point_3{} : uniform_point(random);
            const double off = family == Family_3::cospherical_near ? std::ldexp(1.0, -integer(random, 10, 52)) : 0.0;
            each([&] {
                Point_3 p = unit_vector(random);
                const double r = radius * (1 + off * between(random, -1, 1));
                for (std::size_t k = 0; k < 3; ++k) p[k] = centre[k] + r * p[k];
                return p;
            });
            break;
        }
        case Family_3::cospherical_exact: {
            // Signs and orders of three numbers, and of another triple of the same norm: 1 + 64 + 64 = 16 + 64 + 49,
            // and the like.
            static constexpr std::array<std::array<int, 3>, 6> triples{
                {{1, 8, 8}, {4, 8, 7}, {4, 4, 1}, {1, 4, 4}, {2, 1, 2}, {5, 0, 0}}};
            const Point_3 centre = small(random, 50);
            const int exponent = integer(random, -20, 20);
            const std::size_t first = 2 * (random() % 2);
            each([&] {
                auto t = triples[first + random() % 2];
                std::shuffle(t.begin(), t.end(), random);
                Point_3 p;
                for (std::size_t k = 0; k < 3; ++k)
                    p[k] = std::ldexp(centre[k] + (random() % 2 == 0 ? t[k] : -t[k]), exponent);
                return p;
            });
            break;
        }
        case Family_3::theta_zero: {
            const double flat = std::ldexp(1.0, -integer(random, 4, 55));
            each([&] { return uniform_point(random); });
            for (std::size_t i = 0; i < 3; ++i) x[i][2] = 0;
            x[3][2] = -flat * unit(random);
            x[4][2] = flat * unit(random);
            turn(x, random);
            break;
        }
        case Family_3::sliver: {
            const double flat = std::ldexp(1.0, -integer(random, 10, 50));
            each([&] { return uniform_point(random); });
            for (Point_3& p : x) p[2] *= flat;
            turn(x, random);
            break;
        }
        case Family_3::needle: {
            const double length = std::ldexp(1.0, -integer(random, 1, 50));
            each([&] { return uniform_point(random); });
            const Point_3 v = unit_vector(random);
            for (std::size_t k = 0; k < 3; ++k) x[1][k] = x[0][k] + length * v[k];
            break;
        }
        case Family_3::flat_sphere: {
            const double flat = std::ldexp(1.0, -integer(random, 10, 50));
            each([&] {
                const double angle = between(random, 0, 6.28);
                return Point_3{std::cos(angle), std::sin(angle), flat * between(random, -1, 1)};
            });
            x[4] = random() % 2 == 0 ? uniform_point(random) : unit_vector(random);
            turn(x, random);
            break;
        }
        case Family_3::tiny:
        case Family_3::huge: {
            static constexpr std::array bases{Family_3::uniform, Family_3::grid, Family_3::cospherical_near,
                                              Family_3::sliver};
            if (family == Family_3::huge && random() % 4 == 0) {
                const std::array<double, 5> ends{0.0, 0x1p500, -0x1p500, std::nextafter(0x1p500, 0.0), -0.0};
                each([&] { return Point_3{ends[random() % 5], ends[random() % 5], ends[random() % 5]}; });
                break;
            }
            x = five(bases[random() % bases.size()], random);
            double largest = 0x1p-60;
            for (const Point_3& p : x)
                for (const double c : p) largest = std::max(largest, std::fabs(c));
            const int magnitude = family == Family_3::tiny ? integer(random, -420, -380) : integer(random, 380, 500);
            for (Point_3& p : x)
                for (double& c : p) c = std::ldexp(c, magnitude - std::ilogb(largest) - 1);
            break;
        }
        case Family_3::subnormal: {
            const int bits = integer(random, 2, 52);
            each([&] {
                Point_3 p;
                for (double& c : p)
                    c = (random() % 2 == 0 ? 1.0 : -1.0) *
                        std::ldexp(static_cast<double>(random() >> (64 - bits)), -1074);
                return p;
            });
            break;
        }
        case Family_3::far_offset: {
            const int most = integer(random, 1, 20);
            each([&] {
                Point_3 p = small(random, most);
                p[0] += 0x1p40;
                p[1] -= 0x1p40;
                return p;
            });
            break;
        }
        case Family_3::mixed_scales:
            each([&] { return Point_3{any_in_domain(random), any_in_domain(random), any_in_domain(random)}; });
            break;
    }
    return x;
}

/// Reverses the facet if necessary; true when x then has the points of a bi-cell.
bool arrange(Five& x) {
    const int q = exact_orientation(x[0], x[1], x[2], x[4]);
    if (q == 0 || exact_orientation(x[0], x[1], x[2], x[3]) != -q) return false;
    if (q < 0) std::swap(x[0], x[1]);
    return true;
}

}  // namespace

Bicell_3 bicell(Family_3 family, Random& random) {
    for (int tries = 0; tries < 10000; ++tries) {
        Five x = five(family, random);
        bool arranged = arrange(x);
        for (int order = 0; order < 12 && !arranged; ++order) {
            std::shuffle(x.begin(), x.end(), random);
            arranged = arrange(x);
        }
        if (arranged) return {x[0], x[1], x[2], x[3], x[4]};
    }
    throw std::logic_error("no bi-cell of this family");
}

Bicell_3 delaunay_bicell(Family_3 family, Random& random) {
    for (int tries = 0; tries < 10000; ++tries) {
        const Bicell_3 c = bicell(family, random);
        if (exact_empty_sphere(c.a, c.b, c.c, c.q, c.p) >= 0) return c;
    }
    throw std::logic_error("no Delaunay bi-cell of this family");
}

Tetrahedron tetrahedron(Family_3 family, Random& random) {
    const Five x = five(family, random);
    return {x[0], x[1], x[2], x[4]};
}

std::string_view name_of(Family_3 family) {
    switch (family) {
        case Family_3::uniform: return "uniform";
        case Family_3::grid: return "grid";
        case Family_3::noisy_grid: return "noisy grid";
        case Family_3::cospherical_rounded: return "cospherical, rounded";
        case Family_3::cospherical_near: return "cospherical, near";
        case Family_3::cospherical_exact: return "cospherical, exact";
        case Family_3::theta_zero: return "theta -> 0";
        case Family_3::sliver: return "sliver";
        case Family_3::needle: return "needle";
        case Family_3::flat_sphere: return "flat sphere";
        case Family_3::tiny: return "tiny";
        case Family_3::subnormal: return "subnormal";
        case Family_3::huge: return "huge";
        case Family_3::far_offset: return "far offset";
        case Family_3::mixed_scales: return "mixed scales";
    }
    return "?";
}

std::string as_code(const Point_3& p) {
    return "{" + as_code(p[0]) + ", " + as_code(p[1]) + ", " + as_code(p[2]) + "}";
}
std::string as_code(const Bicell_3& c) {
    return "const annulus::testing::Bicell_3 x{" + as_code(c.a) + ", " + as_code(c.b) + ", " + as_code(c.c) + ", " +
           as_code(c.p) + ", " + as_code(c.q) + "};";
}
std::string as_code(const Tetrahedron& t) {
    return "const annulus::testing::Tetrahedron x{" + as_code(t.a) + ", " + as_code(t.b) + ", " + as_code(t.c) + ", " +
           as_code(t.d) + "};";
}

}  // namespace annulus::testing
