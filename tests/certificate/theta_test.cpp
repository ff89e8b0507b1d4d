// SPDX-License-Identifier: GPL-3.0-or-later
// The angle of a bi-cell beside MPFR's.

#include <support/arbitrary.h>
#include <support/stages.h>

#include <annulus/certificate/theta.h>

#include <mpfr.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double half_turn = std::numbers::pi / 2;

struct Number {
    mpfr_t value;
    Number() { mpfr_init2(value, 2500); }
    ~Number() { mpfr_clear(value); }
    Number(const Number&) = delete;
    Number& operator=(const Number&) = delete;
};

/// The angle between the lines a b and p q, which is the one between their normals: atan2 of cross and dot product.
double angle_between_lines(const Bicell& c) {
    Number bx, by, ex, ey, cross, dot, product;
    const auto difference = [](Number& r, double x, double y) {
        mpfr_set_d(r.value, x, MPFR_RNDN);
        mpfr_sub_d(r.value, r.value, y, MPFR_RNDN);
    };
    difference(bx, c.b[0], c.a[0]);
    difference(by, c.b[1], c.a[1]);
    difference(ex, c.q[0], c.p[0]);
    difference(ey, c.q[1], c.p[1]);
    mpfr_mul(cross.value, bx.value, ey.value, MPFR_RNDN);
    mpfr_mul(product.value, by.value, ex.value, MPFR_RNDN);
    mpfr_sub(cross.value, cross.value, product.value, MPFR_RNDN);
    mpfr_mul(dot.value, bx.value, ex.value, MPFR_RNDN);
    mpfr_mul(product.value, by.value, ey.value, MPFR_RNDN);
    mpfr_add(dot.value, dot.value, product.value, MPFR_RNDN);
    mpfr_abs(cross.value, cross.value, MPFR_RNDN);
    mpfr_abs(dot.value, dot.value, MPFR_RNDN);
    mpfr_atan2(cross.value, cross.value, dot.value, MPFR_RNDN);
    return mpfr_get_d(cross.value, MPFR_RNDN);
}

double theta_of(const Bicell& c) { return theta(c.a, c.b, c.p, c.q); }

/// The sine is off by a few units of 1; the angle by their root where the sine is near 1.
bool is_close(double angle, double truth) {
    return angle >= 0 && angle <= half_turn && std::fabs(std::sin(angle) - std::sin(truth)) <= 8 * 0x1p-53 &&
           std::fabs(angle - truth) <= 8 * 0x1p-53 / std::max(0x1p-25, std::cos(truth));
}

bool is_extreme(Bicell_family family) {
    return family == Bicell_family::subnormal || family == Bicell_family::mixed_scales;
}

}  // namespace

TEST_CASE("theta is the angle between the axis of the facet and the bisector of the opposite vertices",
          "[certificate]") {
    REQUIRE(rc::check("of bi-cells of the usual magnitudes, up to 2^500 and down to 2^-400", [](const Seed& seed) {
        Random random = seed.random();
        for (const Bicell_family family : all_bicell_families)
            for (int i = 0; i < 5 && !is_extreme(family); ++i) {
                const Bicell c = bicell(family, random);
                HOLDS(is_close(theta_of(c), angle_between_lines(c)), c);
                HOLDS(theta_of(c) == theta_of(c.turned()), c);
            }
    }));
}

TEST_CASE("theta of the smallest numbers", "[certificate]") {
    Random random(23);
    for (const Bicell_family family : {Bicell_family::subnormal, Bicell_family::mixed_scales})
        for (int i = 0; i < 300; ++i) {
            const Bicell c = bicell(family, random);
            if (is_close(theta_of(c), angle_between_lines(c))) continue;
            FAIL_CHECK(as_code(c) << "\n" << theta_of(c) << " instead of " << angle_between_lines(c));
            i = 300;  // one of a family is enough
        }
    const double x = 0x1p-1074;
    CHECK(theta({0, 0}, {x, x}, {x, 0}, {0, x}) == Approx(half_turn));
    CHECK(theta({0, 0}, {0x1p-600, 0x1p-600}, {0x1p-600, 0}, {0, 0x1p-600}) == Approx(half_turn));
}

TEST_CASE("known angles", "[certificate]") {
    // The sine is accurate, so that a right angle is good to half the digits only.
    CHECK(theta({0, 0}, {1, 1}, {1, 0}, {0, 1}) == Approx(half_turn).margin(3e-8));  // a square
    CHECK(theta({0, 0}, {1, 0}, {0.5, -1}, {0.5, 1}) == half_turn);                  // a kite
    CHECK(theta({0, 0}, {1, 0}, {0, -1}, {2, 1}) == Approx(std::numbers::pi / 4).epsilon(1e-15));
    CHECK(theta({0, 0}, {0, 1}, {1, 0}, {-1, 2}) == Approx(std::numbers::pi / 4).epsilon(1e-15));
    CHECK(theta({0, 0}, {1, 0}, {-5, -0x1p-40}, {5, 0x1p-40}) == Approx(0x1p-39 / 10).epsilon(1e-12));
    CHECK(theta({0, 0}, {1, 0}, {3, 3}, {3, 3}) == 0.0);  // no direction: 0 by convention
    CHECK(theta({0, 0}, {0, 0}, {0, 1}, {3, 3}) == 0.0);
    CHECK(theta({0, 0}, {0x1p500, 0}, {0, -0x1p500}, {0, 0x1p500}) == half_turn);
}

TEST_CASE("the slab of the paper is the altitude over the first side", "[certificate]") {
    const Triangle t{{0, 0}, {4, 0}, {0, 3}};
    CHECK(paper_slab(t.tuple()) == 1.5);
    CHECK(paper_slab(t.rotated().tuple()) == Approx(1.2).epsilon(1e-15));
    CHECK(paper_slab(t.rotated().rotated().tuple()) == 2.0);
    REQUIRE(rc::check("never below the certified tolerance, which is of the least altitude", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 50; ++i) {
            const Triangle u = triangle(Triangle_family::uniform, random);
            const Verdict v = ladder(u);
            if (v.sign > 0) HOLDS(v.tolerance <= paper_slab(u.tuple()) * (1 + 1e-9), u);
        }
    }));
}
