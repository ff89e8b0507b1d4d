// SPDX-License-Identifier: GPL-3.0-or-later
// The slack of a stage that decides is at most the stated one: a tolerance of 0 would be sound, too.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/oracle.h>
#include <support/stages.h>

#include <annulus/predicate/bounds.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// The filter subtracts det_error and adds norm_error, each at most filter_slack of the computed value; the computed
/// value may itself be too small (determinant) or too large (roots) by as much again. The last unit is of second order.
constexpr double filter_gives_away = 4 * bounds::filter_slack + 16 * bounds::filter_slack * bounds::filter_slack;
/// The interval stage compares the ends of its answer.
constexpr double interval_gives_away = bounds::interval_slack * (1 + 0x1p-40);
/// In the range of subnormal numbers nothing is relative.
constexpr double least_unit = 0x1p-1074;

bool within(const Enclosure& truth, double y, double share) {
    return truth.slack(y) <= share || truth.upper() - y <= 2 * least_unit;
}

/// The largest double not above truth (1 - 2^-100).
bool is_best(const Enclosure& truth, double y) { return truth.slack(std::nextafter(y, HUGE_VAL)) < 0x1p-100; }

template <class Case, class Truth>
void check(const Case& x, const Truth& truth) {
    if (truth.sign() <= 0) return;
    const Enclosure half_width = truth.enclosure();
    const Answers answers = answers_of(x);
    HOLDS(!answers.filter || within(half_width, answers.filter->tolerance, filter_gives_away), x);
    HOLDS(!answers.interval || within(half_width, answers.interval->tolerance, interval_gives_away), x);
    HOLDS(is_best(half_width, answers.exact.tolerance), x);
    HOLDS(within(half_width, answers.exact.tolerance, 0x1p-52), x);
    HOLDS(within(half_width, all_stages(x).tolerance, std::max(filter_gives_away, interval_gives_away)), x);
}

struct Slacks {
    std::vector<double> filter, interval, exact, floating;
};

template <class Case, class Truth>
void measure(const Case& x, const Truth& truth, Slacks& slacks) {
    if (truth.sign() <= 0) return;
    const Enclosure half_width = truth.enclosure();
    const Answers answers = answers_of(x);
    if (answers.filter) slacks.filter.push_back(half_width.slack(answers.filter->tolerance));
    if (answers.interval) slacks.interval.push_back(half_width.slack(answers.interval->tolerance));
    slacks.exact.push_back(half_width.slack(answers.exact.tolerance));
    if (answers.floating) slacks.floating.push_back(std::fabs(half_width.slack(answers.floating->tolerance)));
}

double quantile(std::vector<double> x, double share) {
    REQUIRE(!x.empty());
    const auto i = static_cast<std::ptrdiff_t>(share * static_cast<double>(x.size() - 1));
    std::nth_element(x.begin(), x.begin() + i, x.end());
    return x[static_cast<std::size_t>(i)];
}

void print(const char* what, const Slacks& s) {
    std::printf(
        "relative slack on uniform %s (median, 99%%): filter %.1e %.1e, interval %.1e %.1e, exact %.1e %.1e, "
        "|floating| %.1e %.1e\n",
        what, quantile(s.filter, 0.5), quantile(s.filter, 0.99), quantile(s.interval, 0.5), quantile(s.interval, 0.99),
        quantile(s.exact, 0.5), quantile(s.exact, 0.99), quantile(s.floating, 0.5), quantile(s.floating, 0.99));
}

}  // namespace

TEST_CASE("a stage that answers is within its slack of the truth", "[certificate]") {
    REQUIRE(for_all("on triangles of every family", [](const Seed& seed) {
        for_each_triangle(seed.random(), 4, [](const Triangle& t) { check(t, Triangle_truth(t)); });
    }));
    REQUIRE(for_all("on Delaunay bi-cells of every family", [](const Seed& seed) {
        for_each_delaunay_bicell(seed.random(), 3, [](const Bicell& c) { check(c, Bicell_truth(c)); });
    }));
}

TEST_CASE("the slack of the interval stage is met where the scaled tolerance is subnormal", "[certificate]") {
    // The slack allowed was rounded upward: 5 units of 2^-1074 where 4.2 are stated.
    const Triangle x{{0x0p+0, -0x0.aa671b0d3e13ep-1022},
                     {-0x0.0000008p-1022, 0x1.557dfd8b4e1d2p-726},
                     {-0x1p+335, 0x1.f1840c8b3a8fap-408}};
    check(x, Triangle_truth(x));
}

TEST_CASE("the typical slack is far below the stated one", "[certificate]") {
    Random random(20);
    Slacks triangles, bicells;
    for (int i = 0; i < 3000; ++i) {
        const Triangle t = triangle(Triangle_family::uniform, random);
        measure(t, Triangle_truth(t), triangles);
        const Bicell c = delaunay_bicell(Bicell_family::uniform, random);
        measure(c, Bicell_truth(c), bicells);
    }
    print("triangles", triangles);
    print("bi-cells", bicells);
    CHECK(quantile(triangles.filter, 0.5) < 1e-13);
    CHECK(quantile(triangles.interval, 0.5) < 3e-15);
    CHECK(quantile(triangles.exact, 1.0) <= 0x1p-52);
    CHECK(quantile(bicells.filter, 0.5) < 1e-11);
    CHECK(quantile(bicells.interval, 0.5) < 1e-14);
    CHECK(quantile(bicells.exact, 1.0) <= 0x1p-52);
    // Lower bounds, so never on the other side.
    CHECK(quantile(triangles.filter, 0.0) >= 0);
    CHECK(quantile(bicells.filter, 0.0) >= 0);
    CHECK(quantile(bicells.interval, 0.0) >= 0);
    CHECK(quantile(bicells.exact, 0.0) >= 0);
}

TEST_CASE("without certification the tolerance is the plain quotient, a few ulps from the truth", "[certificate]") {
    // Well-shaped: points of a square or an equilateral triangle, off by a tenth.
    Random random(21);
    Slacks triangles, bicells;
    const auto near = [&random](double x, double y) {
        return Point{x + between(random, -0.1, 0.1), y + between(random, -0.1, 0.1)};
    };
    for (int i = 0; i < 2000; ++i) {
        const Triangle t{near(0, 0), near(1, 0), near(0.5, 0.87)};
        measure(t, Triangle_truth(t), triangles);
        const Bicell c{near(0, 0), near(1, 0), near(0.5, -0.87), near(0.5, 0.87)};
        measure(c, Bicell_truth(c), bicells);
    }
    REQUIRE(triangles.floating.size() == 2000);
    REQUIRE(bicells.floating.size() == 2000);
    CHECK(quantile(triangles.floating, 0.5) <= 2 * 0x1p-52);
    CHECK(quantile(triangles.floating, 1.0) <= 8 * 0x1p-52);
    CHECK(quantile(bicells.floating, 0.5) <= 4 * 0x1p-52);
    CHECK(quantile(bicells.floating, 1.0) <= 16 * 0x1p-52);
}

TEST_CASE("half widths known in closed form", "[certificate]") {
    SECTION("a triangle 3 4 5: least altitude 12/5") {
        const Triangle t{{0, 0}, {4, 0}, {0, 3}};
        const Answers answers = answers_of(t);
        REQUIRE(answers.filter);
        REQUIRE(answers.interval);
        for (const Certificate_value& v : {*answers.filter, *answers.interval, answers.exact}) {
            CHECK(v.sign == 1);
            CHECK(v.tolerance == Approx(1.2).epsilon(1e-14));
            CHECK(v.tolerance <= 1.2);
        }
        CHECK(paper_slab({&t.b, &t.c, &t.a}) == Approx(1.2).epsilon(1e-15));
    }
    SECTION("an exact half width is found exactly: 1/4 of a triangle with altitude 1/2") {
        const Triangle t{{-1, 0}, {1, 0}, {0, 0.5}};
        CHECK(orientation_exact(t.tuple()).tolerance == 0.25);
    }
    SECTION("a kite about the origin: radii 1 and 3, half width 1") {
        const Bicell c{{0, -1}, {0, 1}, {3, 0}, {-3, 0}};
        const Answers answers = answers_of(c);
        REQUIRE(answers.filter);
        REQUIRE(answers.interval);
        CHECK(answers.exact.tolerance == 1.0);
        CHECK(answers.filter->tolerance == Approx(1.0).epsilon(1e-12));
        CHECK(answers.filter->tolerance <= 1.0);
        CHECK(answers.interval->tolerance == Approx(1.0).epsilon(1e-14));
        CHECK(answers.interval->tolerance <= 1.0);
    }
    SECTION("a square: half width 0") {
        const Bicell c{{0, 0}, {1, 1}, {1, 0}, {0, 1}};
        CHECK(!empty_sphere_exact(c.tuple()).sign);
        CHECK(empty_sphere_exact(c.tuple()).tolerance == 0.0);
    }
}
