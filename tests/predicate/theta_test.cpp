// SPDX-License-Identifier: GPL-3.0-or-later
// The angle of a bi-cell compared with MPFR's.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages.h>

#include <annulus/predicate/theta.h>

#include <gmpxx.h>
#include <mpfr.h>

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
    REQUIRE(for_all("of bi-cells of the usual magnitudes, up to 2^500 and down to 2^-400", [](const Seed& seed) {
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
    // The sine is accurate, so that a right angle is accurate to half the digits only.
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
    REQUIRE(for_all("never below the certified tolerance, which is of the least altitude", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 50; ++i) {
            const Triangle u = triangle(Triangle_family::uniform, random);
            const Certificate_value v = all_stages(u);
            if (v.sign > 0) HOLDS(v.tolerance <= paper_slab(u.tuple()) * (1 + 1e-9), u);
        }
    }));
}

TEST_CASE("theta in space", "[certificate][space]") {
    // q - p along the normal, across it, and between.
    CHECK(theta({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2, 0.2, -1}, {0.2, 0.2, 1}) == half_turn);
    CHECK(theta({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 1}) == 0.0);
    CHECK(theta({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0, 2, 1}) == Approx(std::numbers::pi / 4).epsilon(1e-15));
    CHECK(theta({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-5, 0, -0x1p-40}, {5, 0, 0x1p-40}) ==
          Approx(0x1p-39 / 10).epsilon(1e-12));
    // At both ends of the domain, and where there is no direction.
    for (const double x : {0x1p-1074, 0x1p-1060, 0x1p-600, 0x1p499}) {
        INFO("x = " << as_code(x));
        CHECK(theta({0, 0, 0}, {x, 0, 0}, {0, x, 0}, {0, 0, -x}, {0, 0, x}) == half_turn);
        CHECK(theta({0, 0, 0}, {x, 0, 0}, {0, x, 0}, {0, 0, 0}, {0, x, x}) ==
              Approx(std::numbers::pi / 4).epsilon(1e-15));
    }
    CHECK(theta({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}, {1, 1, 1}) == 0.0);
    CHECK(theta({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {1, 0, 1}, {1, 1, 0}) == 0.0);
    // sin(theta) = |(p - q).n| / (|p - q| |n|) of random bi-cells, in the order of any corner and from both sides.
    Random random(24);
    for (int i = 0; i < 500; ++i) {
        std::array<Coordinates<3>, 5> x;
        for (auto& p : x)
            for (double& c : p) c = between(random, -1, 1);
        const double angle = theta(x[0], x[1], x[2], x[3], x[4]);
        std::array<mpq_class, 3> u, v, e;
        for (std::size_t k = 0; k < 3; ++k) {
            u[k] = mpq_class(x[1][k]) - mpq_class(x[0][k]);
            v[k] = mpq_class(x[2][k]) - mpq_class(x[0][k]);
            e[k] = mpq_class(x[4][k]) - mpq_class(x[3][k]);
        }
        const mpq_class n0 = u[1] * v[2] - u[2] * v[1], n1 = u[2] * v[0] - u[0] * v[2], n2 = u[0] * v[1] - u[1] * v[0];
        const mpq_class along = e[0] * n0 + e[1] * n1 + e[2] * n2;
        const mpq_class sine_2 =
            along * along / ((e[0] * e[0] + e[1] * e[1] + e[2] * e[2]) * (n0 * n0 + n1 * n1 + n2 * n2));
        CHECK(std::sin(angle) == Approx(std::sqrt(sine_2.get_d())).epsilon(1e-11));
        CHECK(angle == Approx(theta(x[1], x[2], x[0], x[4], x[3])).epsilon(1e-7));
    }
}
