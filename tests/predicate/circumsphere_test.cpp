// SPDX-License-Identifier: GPL-3.0-or-later
// The sphere of a cell against rational numbers, and where its error bounds matter: next to a change of sign, and at
// the ends of their range.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/stages_3.h>

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/orientation_sign.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Random points, the last one moved along a coordinate to where sign(x) changes, exactly up to the last bit. False if
/// it does not change.
template <std::size_t n, class Sign>
bool find_change(Random& random, std::array<Point_3, n>& x, Sign sign) {
    for (Point_3& p : x)
        for (double& c : p) c = between(random, -1, 1);
    double& c = x[n - 1][random() % 3];
    const auto sign_at = [&](double value) {
        c = value;
        return sign(x) > 0;
    };
    double low = -1.0, high = 1.0;
    const bool below = sign_at(low);
    if (sign_at(high) == below) return false;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) break;
        (sign_at(middle) == below ? low : high) = middle;
    }
    c = random() % 2 == 0 ? low : high;
    return true;
}

Circumsphere_3 sphere_of(double x, double y, double z) {
    return Circumsphere_3({0, 0, 0}, {x, 0, 0}, {0, y, 0}, {0, 0, z});
}

}  // namespace

TEST_CASE("The sphere of a cell claims no sign that is within its error", "[certificate][space]") {
    REQUIRE(for_all("of the cell", [](const Seed& seed) {
        Random random = seed.random();
        std::array<Point_3, 4> x;
        const auto sign = [](const auto& y) { return exact_orientation(y[0], y[1], y[2], y[3]); };
        for (int i = 0; i < 8; ++i)
            if (find_change(random, x, sign)) {
                if (Circumsphere_3(x[0], x[1], x[2], x[3]).positive())
                    HOLDS(sign(x) > 0, (Tetrahedron{x[0], x[1], x[2], x[3]}));
                const int clear = orientation_sign(Tuple<3, 4>{&x[0], &x[1], &x[2], &x[3]});
                if (clear != 0) HOLDS(clear == sign(x), (Tetrahedron{x[0], x[1], x[2], x[3]}));
            }
    }));
    REQUIRE(for_all("of the point", [](const Seed& seed) {
        Random random = seed.random();
        std::array<Point_3, 5> x;
        const auto sign = [](const auto& y) { return exact_empty_sphere(y[0], y[1], y[2], y[3], y[4]); };
        for (int i = 0; i < 16; ++i) {
            if (!find_change(random, x, sign)) continue;
            const Circumsphere_3 sphere(x[0], x[1], x[2], x[3]);
            if (sphere.positive() && sphere.excludes(x[4]))
                HOLDS(sign(x) > 0, (Bicell_3{x[0], x[1], x[2], x[4], x[3]}));
            if (sphere.positive() && sphere.contains(x[4]))
                HOLDS(sign(x) < 0, (Bicell_3{x[0], x[1], x[2], x[4], x[3]}));
            // All at once: never true where the single test is false, nor for a corner.
            const Point_3 far{65.0 * x[0][0] - 64.0 * x[4][0], 65.0 * x[0][1] - 64.0 * x[4][1],
                              65.0 * x[0][2] - 64.0 * x[4][2]};
            const bool one = sphere.positive() && sphere.excludes(x[4]);
            const bool both = one && sphere.excludes(far);
            RC_ASSERT(sphere.excludes_all(x[4]) == one);
            RC_ASSERT(!sphere.excludes_all(x[4], far) || both);
            RC_ASSERT(!sphere.excludes_all(x[4], far, x[0]));
            RC_ASSERT(!sphere.excludes_all(x[4], Point_3{0x1p500, 0, 0}));
        }
    }));
}

TEST_CASE("The sphere of a cell answers in the range of its error bounds and nowhere else", "[certificate][space]") {
    const double most = bounds::filter_range_3, least = 1 / bounds::filter_range_3;
    for (const double x : {least, std::nextafter(least, 1.0), 1.0, std::nextafter(most, 1.0), most}) {
        INFO("x = " << as_code(x));
        CHECK(sphere_of(x, x, x).positive());
        // Around (x / 2, x / 2, x / 2), through the cube's corners.
        CHECK(sphere_of(x, x, x).excludes({-0.5 * x, -0.5 * x, -0.5 * x}));
        CHECK(sphere_of(x, x, x).excludes({0.5 * x, 0.5 * x, -0.5 * x}));
        CHECK(!sphere_of(x, x, x).excludes({x, x, x}));
        CHECK(sphere_of(x, x, x).contains({0.5 * x, 0.5 * x, 0.5 * x}));
        CHECK(!sphere_of(x, x, x).contains({x, x, x}));
    }
    for (const double x : {std::nextafter(least, 0.0), std::nextafter(most, HUGE_VAL), 0x1p-258, 0x1p190}) {
        INFO("x = " << as_code(x));
        CHECK(!sphere_of(x, x, x).positive());
        CHECK(!sphere_of(x, 0.5 * x, 0.5 * x).positive());
        CHECK(!sphere_of(0.5 * x, x, 0.5 * x).positive());
        CHECK(!sphere_of(0.5 * x, 0.5 * x, x).positive());
    }
    const Circumsphere_3 large = sphere_of(0.5 * most, 0.5 * most, 0.5 * most);
    CHECK(large.excludes({-most, most, -most}));
    for (std::size_t k = 0; k < 3; ++k) {
        Point_3 p{};
        p[k] = -2 * most;
        CHECK(!large.excludes(p));
    }
}

TEST_CASE("The sphere of a cell claims nothing that is not so", "[certificate][space]") {
    const auto check = [](const std::array<Point_3, 4>& x, const Point_3& p) {
        const Circumsphere_3 sphere(x[0], x[1], x[2], x[3]);
        if (!sphere.positive()) return false;
        HOLDS(exact_orientation(x[0], x[1], x[2], x[3]) > 0, (Tetrahedron{x[0], x[1], x[2], x[3]}));
        if (!sphere.excludes(p)) return false;
        HOLDS(exact_empty_sphere(x[0], x[1], x[2], x[3], p) > 0, (Bicell_3{x[0], x[1], x[2], p, x[3]}));
        return true;
    };
    REQUIRE(for_all("of bi-cells of every family, whichever corner comes first", [&check](const Seed& seed) {
        Random random = seed.random();
        for_each_bicell_3(seed.random(), 4, [&](const Bicell_3& c) {
            std::array<Point_3, 4> x{c.a, c.b, c.c, c.q};
            // Even permutations: the orientation stays.
            const auto even = static_cast<std::ptrdiff_t>(random() % 3);
            std::rotate(x.begin(), x.begin() + even, x.begin() + 3);
            if (random() % 2 == 0) {
                std::swap(x[0], x[3]);
                std::swap(x[1], x[2]);
            }
            (void)check(x, c.p);
            (void)check({c.b, c.a, c.c, c.p}, c.q);
        });
    }));
    REQUIRE(for_all("and it says so of nearly every ordinary one", [&check](const Seed& seed) {
        Random random = seed.random();
        int claimed = 0;
        for (int i = 0; i < 100; ++i) {
            const Bicell_3 c = delaunay_bicell(Family_3::uniform, random);
            claimed += check({c.a, c.b, c.c, c.q}, c.p) || check({c.b, c.a, c.c, c.q}, c.p) ? 1 : 0;
        }
        RC_ASSERT(claimed > 95);
    }));
}
