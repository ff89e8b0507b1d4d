// SPDX-License-Identifier: GPL-3.0-or-later
// Every stage that decides has the exact sign; the exact stage always decides, with 0 exactly where the points are
// degenerate.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages.h>

#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/orientation_sign.h>

#include <algorithm>
#include <array>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <class Case>
void check_signs(const Case& x, int truth) {
    const Answers answers = answers_of(x);
    HOLDS(answers.exact.sign == truth, x);
    HOLDS(answers.exact.stage == Stage::exact, x);
    HOLDS(!answers.filter || answers.filter->sign == truth, x);
    HOLDS(!answers.filter || answers.filter->stage == Stage::filter, x);
    HOLDS(!answers.floating || answers.floating->sign == truth, x);
    HOLDS(!answers.interval || answers.interval->sign == truth, x);
    HOLDS(!answers.interval || answers.interval->stage == Stage::interval, x);
    HOLDS(all_stages(x).sign == truth, x);
    HOLDS(all_stages(x, false).sign == truth, x);
    HOLDS(truth > 0 || all_stages(x).tolerance == 0.0, x);
    HOLDS(truth > 0 || all_stages(x, false).tolerance == 0.0, x);
}

void check_signs(const Triangle& t) {
    const int truth = exact_orientation(t.a, t.b, t.c);
    check_signs(t, truth);
    const Tuple<2, 3> x{&t.a, &t.b, &t.c};
    HOLDS(exact_orientation_sign(x).sign == truth, t);
    HOLDS(orientation_sign(x) == 0 || orientation_sign(x) == truth, t);
}
void check_signs(const Bicell& c) {
    const int truth = exact_empty_circle(c.a, c.b, c.q, c.p);
    check_signs(c, truth);
    HOLDS(exact_empty_sphere_sign(Tuple<2, 4>{&c.a, &c.b, &c.p, &c.q}).sign == truth, c);
    const Circumcircle_2 circle(c.a, c.b, c.q);
    if (!circle.positive()) return;
    HOLDS(!circle.excludes(c.p) || truth > 0, c);
    HOLDS(!circle.contains(c.p) || truth < 0, c);
    // All at once: never true where the single test is false, nor for a corner.
    const Coordinates<2> far{c.a[0] + 64.0 * (c.a[0] - c.p[0]), c.a[1] + 64.0 * (c.a[1] - c.p[1])};
    HOLDS(circle.excludes_all(c.p) == circle.excludes(c.p), c);
    HOLDS(!circle.excludes_all(c.p, far) || (circle.excludes(c.p) && circle.excludes(far)), c);
    HOLDS(!circle.excludes_all(far, c.a, c.p) && !circle.excludes_all(c.p, far, c.q), c);
    HOLDS(!circle.excludes_all(c.p, Coordinates<2>{0x1p500, -0x1p500}), c);
}

}  // namespace

TEST_CASE("every stage has the exact sign of the orientation", "[certificate]") {
    REQUIRE(for_all("of triangles of every family", [](const Seed& seed) {
        for_each_triangle(seed.random(), 8, [](const Triangle& t) { check_signs(t); });
    }));
}

TEST_CASE("every stage has the exact sign of the empty circle", "[certificate]") {
    REQUIRE(for_all("of bi-cells of every family", [](const Seed& seed) {
        for_each_bicell(seed.random(), 4, [](const Bicell& c) { check_signs(c); });
    }));
    REQUIRE(for_all("of four points in any order, whatever the orientation of the cells", [](const Seed& seed) {
        Random random = seed.random();
        for_each_bicell(seed.random(), 2, [&random](const Bicell& c) {
            std::array<Point, 4> x{c.a, c.b, c.p, c.q};
            for (std::size_t i = 4; i > 1; --i) std::swap(x[i - 1], x[random() % i]);
            check_signs(Bicell{x[0], x[1], x[2], x[3]});
        });
    }));
    REQUIRE(for_all("of four points some of which are equal", [](const Seed& seed) {
        Random random = seed.random();
        for_each_bicell(seed.random(), 1, [&random](const Bicell& c) {
            std::array<Point, 4> x{c.a, c.b, c.p, c.q};
            x[random() % 4] = x[random() % 4];
            check_signs(Bicell{x[0], x[1], x[2], x[3]});
        });
    }));
}

TEST_CASE("degenerate inputs have sign 0, tolerance 0, and reach the exact stage", "[certificate]") {
    REQUIRE(for_all("collinear points", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 20; ++i) {
            const Triangle t = triangle(Triangle_family::collinear, random);
            const Certificate_value v = all_stages(t);
            HOLDS(v.sign == 0 && v.tolerance == 0.0, t);
            HOLDS(v.stage == Stage::exact, t);
        }
    }));
    REQUIRE(for_all("cocircular points", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 20; ++i) {
            const Bicell c = bicell(Bicell_family::cocircular_exact, random);
            const Certificate_value v = all_stages(c);
            HOLDS(v.sign == 0 && v.tolerance == 0.0, c);
            HOLDS(v.stage == Stage::exact, c);
        }
    }));
}

TEST_CASE("one unit in the last place off a degenerate position is seen", "[certificate]") {
    const double up = std::nextafter(1.0, 2.0), down = std::nextafter(1.0, 0.0);
    for (const double y : {down, 1.0, up}) {
        INFO("y = " << as_code(y));
        const int expected = (y > 1.0) - (y < 1.0);
        const Triangle t{{0, 1}, {1, 1}, {0.5, y}};
        CHECK(all_stages(t).sign == expected);
        CHECK((all_stages(t).tolerance > 0) == (expected > 0));
        // q leaves the circle of the square through its corner (0, 1) upward.
        const Bicell c{{0, 0}, {1, 1}, {1, 0}, {0, y}};
        CHECK(all_stages(c).sign == expected);
        CHECK((all_stages(c).tolerance > 0) == (expected > 0));
    }
    const double tiny = 0x1p-1074;
    CHECK(all_stages(Triangle{{0, 0}, {tiny, 0}, {0, tiny}}).sign == 1);
    CHECK(all_stages(Triangle{{0, 0}, {0x1p500, 0}, {0, tiny}}).sign == 1);
    CHECK(all_stages(Triangle{{-0x1p500, -0x1p500}, {0x1p500, 0x1p500}, {0, tiny}}).sign == 1);
    CHECK(all_stages(Triangle{{-0x1p500, -0x1p500}, {0x1p500, 0x1p500}, {-0.0, 0.0}}).sign == 0);
}

TEST_CASE("The circle of a triangle claims nothing that is not so", "[certificate]") {
    const auto check = [](const Point& a, const Point& b, const Point& c, const Point& p) {
        const Circumcircle_2 circle(a, b, c);
        if (!circle.positive()) return false;
        HOLDS(exact_orientation(a, b, c) > 0, (Triangle{a, b, c}));
        if (!circle.excludes(p)) return false;
        HOLDS(exact_empty_circle(a, b, c, p) > 0, (Bicell{a, b, p, c}));
        return true;
    };
    REQUIRE(for_all("of bi-cells of every family, whichever corner comes first", [&check](const Seed& seed) {
        Random random = seed.random();
        for_each_bicell(seed.random(), 4, [&](const Bicell& c) {
            std::array<Point, 3> x{c.a, c.b, c.q};
            std::rotate(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(random() % 3), x.end());
            (void)check(x[0], x[1], x[2], c.p);
            (void)check(c.p, c.b, c.a, c.q);
        });
    }));
    REQUIRE(for_all("and it says so of nearly every ordinary one", [&check](const Seed& seed) {
        Random random = seed.random();
        int claimed = 0;
        for (int i = 0; i < 100; ++i) {
            const Bicell c = delaunay_bicell(Bicell_family::uniform, random);
            claimed += check(c.a, c.b, c.q, c.p) ? 1 : 0;
        }
        RC_ASSERT(claimed > 95);
    }));
}

TEST_CASE("The circle of a triangle answers in the range of its error bounds and nowhere else", "[certificate]") {
    const double most = bounds::filter_range, least = 1 / bounds::filter_range;
    const auto circle_of = [](double x, double y) { return Circumcircle_2({0, 0}, {x, 0}, {0, y}); };
    for (const double x : {least, std::nextafter(least, 1.0), 1.0, std::nextafter(most, 1.0), most}) {
        INFO("x = " << as_code(x));
        CHECK(circle_of(x, x).positive());
        // The radius is x / sqrt(2) around (x / 2, x / 2).
        CHECK(circle_of(x, x).excludes({-0.5 * x, -0.5 * x}));
        CHECK(circle_of(x, x).excludes({0.5 * x, -0.5 * x}));
        CHECK(!circle_of(x, x).excludes({x, x}));
    }
    for (const double x : {std::nextafter(least, 0.0), std::nextafter(most, HUGE_VAL), 0x1p-258, 0x1p250}) {
        INFO("x = " << as_code(x));
        CHECK(!circle_of(x, x).positive());
        CHECK(!circle_of(x, 0.5 * x).positive());
        CHECK(!circle_of(0.5 * x, x).positive());
    }
    const Circumcircle_2 large = circle_of(0.5 * most, 0.5 * most);
    CHECK(large.excludes({-most, most}));
    CHECK(!large.excludes({-2 * most, 0}));
    CHECK(!large.excludes({0, 2 * most}));
}
