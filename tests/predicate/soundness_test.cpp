// SPDX-License-Identifier: GPL-3.0-or-later
// No stage ever returns a tolerance above half the width, whatever the input.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/oracle.h>
#include <support/stages.h>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

bool is_sane(const Certificate_value& v) {
    if (v.sign <= 0) return v.tolerance == 0.0;
    return v.tolerance >= 0.0 && std::isfinite(v.tolerance);
}

void check_triangle(const Triangle& t) {
    const Triangle_truth truth(t);
    const Answers answers = answers_of(t);
    const auto sound = [&truth](const Certificate_value& v) { return v.sign <= 0 || truth.is_at_least(v.tolerance); };
    HOLDS(!answers.filter || (is_sane(*answers.filter) && sound(*answers.filter)), t);
    HOLDS(!answers.interval || (is_sane(*answers.interval) && sound(*answers.interval)), t);
    HOLDS(is_sane(answers.exact) && sound(answers.exact), t);
    if (truth.sign() <= 0) return;
    const Enclosure half_width = truth.enclosure();
    HOLDS(!answers.filter || !half_width.is_below(answers.filter->tolerance), t);
    HOLDS(!answers.interval || !half_width.is_below(answers.interval->tolerance), t);
    HOLDS(!half_width.is_below(answers.exact.tolerance), t);
}

void check_bicell(const Bicell& c) {
    const Bicell_truth truth(c);
    const Answers answers = answers_of(c);
    const auto sound = [&truth](const Certificate_value& v) {
        return v.sign <= 0 || (truth.is_at_least(v.tolerance) && truth.is_at_least_by_centre(v.tolerance));
    };
    HOLDS(!answers.filter || (is_sane(*answers.filter) && sound(*answers.filter)), c);
    HOLDS(!answers.interval || (is_sane(*answers.interval) && sound(*answers.interval)), c);
    HOLDS(is_sane(answers.exact) && sound(answers.exact), c);
    if (truth.sign() <= 0) return;
    const Enclosure half_width = truth.enclosure();
    HOLDS(!answers.filter || !half_width.is_below(answers.filter->tolerance), c);
    HOLDS(!answers.interval || !half_width.is_below(answers.interval->tolerance), c);
    HOLDS(!half_width.is_below(answers.exact.tolerance), c);
}

/// Triangles as large as their frame allows, all coordinates with full mantissas: there the absolute error bound is
/// smallest relative to the determinant, and the rounding of the roots and the quotient counts most.
Triangle fat_triangle(Random& random) {
    const auto near = [&random](double x) { return x + between(random, -1, 1) * 0x1p-6; };
    return {{near(0), near(0)}, {near(1), near(-1)}, {near(1), near(1)}};
}

/// The same for bi-cells: the determinant is largest on a kite with its facet in the middle.
Bicell fat_bicell(Random& random) {
    const auto near = [&random](double x) { return x + between(random, -1, 1) * 0x1p-4; };
    const double reach = between(random, 0.6, 1.2);
    return {
        {near(0), near(0.5)}, {near(0.5), near(0.5)}, {near(0.25), near(0.5 - reach)}, {near(0.25), near(0.5 + reach)}};
}

/// Bi-cells whose determinant is from 2^-6 down to 2^-44 of its frame to the fourth, where the filter gives up.
Bicell at_the_edge_of_the_filter(Random& random) {
    for (;;) {
        const double first = between(random, 0, 6.28);
        const double off = std::ldexp(between(random, 0.5, 1), -integer(random, 6, 44));
        const Point centre{between(random, -1, 1), between(random, -1, 1)};
        const auto at = [&](double angle, double radius) {
            return Point{centre[0] + radius * std::cos(first + angle), centre[1] + radius * std::sin(first + angle)};
        };
        // Counterclockwise: b, q, a, p.
        const double q = between(random, 0.2, 5.8), a = between(random, q, 6);
        const Bicell c{at(a, 1), at(0, 1), at(between(random, a, 6.28), 1 + off), at(q, 1)};
        if (is_bicell(c)) return c;
    }
}

}  // namespace

TEST_CASE("no stage certifies more than half the least altitude of a triangle", "[certificate]") {
    REQUIRE(for_all("on triangles of every family",
                    [](const Seed& seed) { for_each_triangle(seed.random(), 12, check_triangle); }));
    REQUIRE(for_all("on triangles as large as their frame", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 50; ++i) check_triangle(fat_triangle(random));
    }));
}

TEST_CASE("no stage certifies more than half the width of the standard annulus", "[certificate]") {
    REQUIRE(for_all("on Delaunay bi-cells of every family",
                    [](const Seed& seed) { for_each_delaunay_bicell(seed.random(), 8, check_bicell); }));
    REQUIRE(for_all("on bi-cells as large as their frame", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 25; ++i) check_bicell(fat_bicell(random));
    }));
    REQUIRE(for_all("on bi-cells where the filter gives up", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 50; ++i) check_bicell(at_the_edge_of_the_filter(random));
    }));
}

TEST_CASE("the filtered predicate as a whole is sound", "[certificate]") {
    REQUIRE(for_all("on one triangle", [](const Seed& seed) {
        Random random = seed.random();
        const Triangle t = triangle(all_triangle_families[random() % all_triangle_families.size()], random);
        const Certificate_value v = all_stages(t);
        RC_ASSERT(is_sane(v));
        RC_ASSERT(v.sign <= 0 || Triangle_truth(t).is_at_least(v.tolerance));
    }));
    REQUIRE(for_all("on one bi-cell", [](const Seed& seed) {
        Random random = seed.random();
        const Bicell c = bicell(all_bicell_families[random() % all_bicell_families.size()], random);
        const Certificate_value v = all_stages(c);
        RC_ASSERT(is_sane(v));
        RC_ASSERT(v.sign <= 0 || Bicell_truth(c).is_at_least(v.tolerance));
    }));
}

TEST_CASE("the oracles agree with one another", "[certificate]") {
    REQUIRE(for_all("on triangles", [](const Seed& seed) {
        for_each_triangle(seed.random(), 1, [](const Triangle& t) {
            const Triangle_truth truth(t);
            HOLDS(truth.sign() == exact_orientation(t.a, t.b, t.c), t);
            if (truth.sign() <= 0) return;
            const Enclosure half_width = truth.enclosure();
            HOLDS(half_width.is_tight(100), t);
            HOLDS(truth.is_at_least(half_width.lower()), t);
            HOLDS(!truth.is_at_least(std::nextafter(half_width.upper(), HUGE_VAL)), t);
        });
    }));
    REQUIRE(for_all("on bi-cells", [](const Seed& seed) {
        for_each_delaunay_bicell(seed.random(), 1, [](const Bicell& c) {
            const Bicell_truth truth(c);
            HOLDS(truth.sign() == exact_empty_circle(c.a, c.b, c.q, c.p), c);
            if (truth.sign() <= 0) return;
            const Enclosure half_width = truth.enclosure();
            HOLDS(half_width.is_tight(100), c);
            const double below = half_width.lower(), above = std::nextafter(half_width.upper(), HUGE_VAL);
            HOLDS(truth.is_at_least(below) && truth.is_at_least_by_centre(below), c);
            HOLDS(!truth.is_at_least(above) && !truth.is_at_least_by_centre(above), c);
        });
    }));
}
