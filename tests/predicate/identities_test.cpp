// SPDX-License-Identifier: GPL-3.0-or-later
// Results that must not change when the same certificate is evaluated in another form.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages.h>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <class Case>
Case scaled(Case x, int exponent) {
    for (const Point* p : x.tuple())
        for (double& c : const_cast<Point&>(*p)) c = std::ldexp(c, exponent);
    return x;
}

Triangle translated(const Triangle& t, double dx, double dy) {
    const auto move = [=](const Point& p) { return Point{p[0] + dx, p[1] + dy}; };
    return {move(t.a), move(t.b), move(t.c)};
}
Bicell translated(const Bicell& c, double dx, double dy) {
    const auto move = [=](const Point& p) { return Point{p[0] + dx, p[1] + dy}; };
    return {move(c.a), move(c.b), move(c.p), move(c.q)};
}

Point quarter_turned(const Point& p) { return {-p[1], p[0]}; }
Point mirrored(const Point& p) { return {p[1], p[0]}; }

bool equal(const Certificate_value& l, const Certificate_value& r) {
    return l.sign == r.sign && l.tolerance == r.tolerance;
}
bool equal(const std::optional<Certificate_value>& l, const std::optional<Certificate_value>& r) {
    return l.has_value() == r.has_value() && (!l || equal(*l, *r));
}

/// r is l with every length multiplied by 2^exponent, unless that rounds, be it up to the least normal number.
bool scales(const Certificate_value& l, const Certificate_value& r, int exponent) {
    const double expected = std::ldexp(l.tolerance, exponent);
    if (l.sign != r.sign) return false;
    const bool rounds = std::ldexp(expected, -exponent) != l.tolerance;
    if (!rounds && std::fpclassify(expected) == FP_NORMAL && std::fpclassify(l.tolerance) == FP_NORMAL)
        return r.tolerance == expected;
    return std::fabs(r.tolerance - expected) <= std::ldexp(1.0, -1074) + std::ldexp(1.0, exponent - 1074);
}

template <class Case>
void check_scaling_of_all_stages(const Case& x, int exponent) {
    const Answers before = answers_of(x), after = answers_of(scaled(x, exponent));
    HOLDS(scales(before.exact, after.exact, exponent), x);
    HOLDS(before.interval.has_value() == after.interval.has_value(), x);
    HOLDS(!before.interval || scales(*before.interval, *after.interval, exponent), x);
    HOLDS(before.filter.has_value() == after.filter.has_value(), x);
    HOLDS(!before.filter || scales(*before.filter, *after.filter, exponent), x);
    HOLDS(!before.floating || scales(*before.floating, *after.floating, exponent), x);
}

double largest_coordinate(const Bicell& c) {
    double largest = 0;
    for (const Point* p : c.tuple()) largest = std::max({largest, std::fabs((*p)[0]), std::fabs((*p)[1])});
    return largest;
}
double least_coordinate(const Bicell& c) {
    double least = HUGE_VAL;
    for (const Point* p : c.tuple())
        for (const double x : *p)
            if (x != 0.0) least = std::min(least, std::fabs(x));
    return least;
}

}  // namespace

TEST_CASE("a bi-cell seen from its other side is the same certificate", "[certificate]") {
    REQUIRE(for_all("a <-> b with p <-> q", [](const Seed& seed) {
        for_each_bicell(seed.random(), 5, [](const Bicell& c) {
            HOLDS(is_bicell(c.turned()), c);
            HOLDS(equal(empty_sphere_exact(c.tuple()), empty_sphere_exact(c.turned().tuple())), c);
            HOLDS(all_stages(c).sign == all_stages(c.turned()).sign, c);
        });
    }));
    REQUIRE(for_all("the other diagonal of four points in convex position has the opposite sign", [](const Seed& seed) {
        for_each_bicell(seed.random(), 5, [](const Bicell& c) {
            if (is_bicell(c.flipped())) HOLDS(all_stages(c).sign == -all_stages(c.flipped()).sign, c);
        });
    }));
    REQUIRE(for_all("where the points are not in convex position the circle is empty", [](const Seed& seed) {
        for_each_bicell(seed.random(), 5, [](const Bicell& c) {
            if (!is_bicell(c.flipped()) && exact_orientation(c.a, c.p, c.q) != 0 &&
                exact_orientation(c.b, c.p, c.q) != 0)
                HOLDS(all_stages(c).sign == 1, c);
        });
    }));
}

TEST_CASE("a triangle begins at any of its vertices", "[certificate]") {
    REQUIRE(for_all("rotation keeps sign and exact tolerance, reversal changes the sign", [](const Seed& seed) {
        for_each_triangle(seed.random(), 8, [](const Triangle& t) {
            const Certificate_value v = orientation_exact(t.tuple());
            HOLDS(equal(v, orientation_exact(t.rotated().tuple())), t);
            HOLDS(equal(v, orientation_exact(t.rotated().rotated().tuple())), t);
            HOLDS(all_stages(t).sign == all_stages(t.rotated()).sign, t);
            HOLDS(all_stages(t.reversed()).sign == -all_stages(t).sign, t);
        });
    }));
}

TEST_CASE("a power of two times the coordinates is a power of two times the tolerance", "[certificate]") {
    REQUIRE(for_all("in every stage, inside the range of the filter", [](const Seed& seed) {
        Random random = seed.random();
        for (const Bicell_family family : all_bicell_families)
            for (int i = 0; i < 3; ++i) {
                const Bicell c = bicell(family, random);
                // Far enough from the ends of the range that no square of a small coordinate underflows.
                if (!(largest_coordinate(c) <= 0x1p12 && least_coordinate(c) >= 0x1p-30)) continue;
                check_scaling_of_all_stages(c, integer(random, -60, 60));
                check_scaling_of_all_stages(Triangle{c.a, c.b, c.q}, integer(random, -60, 60));
            }
    }));
    REQUIRE(for_all("in the exact stage, everywhere", [](const Seed& seed) {
        Random random = seed.random();
        for (const Bicell_family family : all_bicell_families)
            for (int i = 0; i < 3; ++i) {
                const Bicell c = bicell(family, random);
                const double most = largest_coordinate(c), least = least_coordinate(c);
                const int up = 500 - std::ilogb(most) - 1, down = -1022 + 53 - std::ilogb(least);
                if (down > up) continue;
                const int exponent = integer(random, down, up);
                HOLDS(scales(empty_sphere_exact(c.tuple()), empty_sphere_exact(scaled(c, exponent).tuple()), exponent),
                      c);
                const Triangle t{c.a, c.b, c.q};
                HOLDS(scales(orientation_exact(t.tuple()), orientation_exact(scaled(t, exponent).tuple()), exponent),
                      t);
            }
    }));
}

TEST_CASE("a tolerance a bit below a power of two times so much is a bit less among subnormal numbers, too",
          "[certificate]") {
    // Its tolerance is the number before 2^446.
    const Triangle t{{0x0p+0, 0x1.fffffffffffffp+499}, {0x1p+500, 0x1p+500}, {0x0p+0, 0x1p+500}};
    const Certificate_value v = orientation_exact(t.tuple());
    REQUIRE(v.tolerance == std::nextafter(0x1p446, 0.0));
    for (int exponent = -1460; exponent >= -1515; --exponent) {
        INFO("exponent " << exponent);
        CHECK(scales(v, orientation_exact(scaled(t, exponent).tuple()), exponent));
    }
    CHECK(orientation_exact(scaled(t, -1468).tuple()).tolerance == std::nextafter(0x1p-1022, 0.0));
}

TEST_CASE("an exact translation changes nothing in any stage", "[certificate]") {
    REQUIRE(for_all("integers, moved by up to 2^50", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) {
            const double dx = std::ldexp(integer(random, -9, 9), integer(random, 0, 46));
            const double dy = std::ldexp(integer(random, -9, 9), integer(random, 0, 46));
            const Bicell c = bicell(Bicell_family::grid, random);
            const Answers before = answers_of(c), after = answers_of(translated(c, dx, dy));
            HOLDS(equal(before.exact, after.exact), c);
            HOLDS(equal(before.interval, after.interval), c);
            HOLDS(equal(before.filter, after.filter), c);
            HOLDS(equal(before.floating, after.floating), c);
            const Triangle t = triangle(Triangle_family::grid, random);
            const Answers t_before = answers_of(t), t_after = answers_of(translated(t, dx, dy));
            HOLDS(equal(t_before.exact, t_after.exact), t);
            HOLDS(equal(t_before.interval, t_after.interval), t);
            HOLDS(equal(t_before.filter, t_after.filter), t);
            HOLDS(equal(t_before.floating, t_after.floating), t);
        }
    }));
}

TEST_CASE("a quarter turn keeps the exact answer; a mirror exchanges the sides", "[certificate]") {
    REQUIRE(for_all("of bi-cells", [](const Seed& seed) {
        for_each_bicell(seed.random(), 3, [](const Bicell& c) {
            const Certificate_value v = empty_sphere_exact(c.tuple());
            const Bicell turned{quarter_turned(c.a), quarter_turned(c.b), quarter_turned(c.p), quarter_turned(c.q)};
            HOLDS(equal(v, empty_sphere_exact(turned.tuple())), c);
            const Bicell mirror{mirrored(c.a), mirrored(c.b), mirrored(c.q), mirrored(c.p)};
            HOLDS(equal(v, empty_sphere_exact(mirror.tuple())), c);
        });
    }));
}
