// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of the filter compared with its errors, maximised by climbing, and how the filter uses them.
//
// A tolerance alone says little about the bounds: the error subtracted from the determinant hides missing terms
// elsewhere (half a width is at most m, so 121 u m^4 of the determinant weighs more than 264 u m^3 of the roots). Here
// each bound is tested separately.

#include "worst_cases.h"

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages.h>

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/decide.h>

#include <cmath>
#include <limits>
#include <tuple>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Coordinates of very different magnitudes, in the range of the filter as a whole.
Numbers spread(std::size_t n, Random& random) {
    Numbers x(n);
    const int exponent = integer(random, -118, 118), depth = integer(random, 0, 1) * 400;
    for (double& c : x) c = std::ldexp(between(random, -1, 1), exponent - integer(random, 0, depth));
    x[random() % n] = std::ldexp(1.0, exponent);
    return x;
}

}  // namespace

TEST_CASE("the filter is never off by more than its bounds", "[certificate]") {
    REQUIRE(for_all("on coordinates of one magnitude and of many", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) {
            const Numbers x = i % 2 == 0 ? start(6, 2, random) : spread(6, random);
            const Plane_errors e = triangle_errors(x);
            if (!(e.determinant <= bounds::orientation_2 && e.roots <= bounds::tail)) RC_FAIL(as_code(x));
            const Numbers y = i % 2 == 0 ? start(8, 2, random) : spread(8, random);
            const Plane_errors f = bicell_errors(y);
            if (!(f.determinant <= bounds::annulus_2_incircle && f.roots <= bounds::annulus_2_norms))
                RC_FAIL(as_code(y));
        }
    }));
}

TEST_CASE("the filter is never off by more than its bounds, sought by climbing", "[certificate]") {
    Random random(run_seed());
    for (const auto& [name, steps, somewhere] :
         {std::tuple{"orientation_2", 8000, 2.0}, std::tuple{"orientation_2 roots", 1000, 0.0},
          std::tuple{"annulus_2_incircle", 6000, 4.0}, std::tuple{"annulus_2_norms", 6000, 4.0}}) {
        CAPTURE(name);
        CHECK(climb_from_anywhere(name, 2, steps, random) > somewhere);
    }
}

TEST_CASE("an orientation off by 8 u m^2", "[certificate]") {
    // Differences just above 1, found by climbing: a bound proved for m = 1 does not hold for every m.
    const Numbers x{0x1.000003d0f177dp-1, 0x1.0000000871f71p-1,  -0x1.fffffff7bd8a4p-2,
                    0x1.800006170d57ap+0, -0x1.fffffb649e77cp-2, -0x1.fffffffff396cp-2};
    CHECK(triangle_errors(x).determinant > 7.9999);
    CHECK(triangle_errors(x).determinant <= bounds::orientation_2);
}

TEST_CASE("the bound of the norms is made of those of the two vectors", "[certificate]") {
    CHECK(bounds::annulus_2_norms >= std::sqrt(2.0) * (bounds::annulus_2_inner + bounds::annulus_2_outer));
    CHECK(bounds::u == std::numeric_limits<double>::epsilon() / 2);
}

TEST_CASE("rounded terms are accepted with their errors taken off, or not at all", "[certificate]") {
    Certificate_value v;
    const auto answers = [&v](double determinant, double root, double det_error, double norm_error,
                              bool certified = true) {
        v = {};
        const auto d = detail::decide(determinant, 2 * root, det_error, norm_error, certified);
        return detail::answer(d.sign, d.tolerance, v);
    };
    const double share = bounds::filter_slack;
    SECTION("without errors it is the quotient less the tail") {
        REQUIRE(answers(3, 1, 0, 0));
        CHECK(v.sign == 1);
        CHECK(v.stage == Stage::filter);
        CHECK(v.tolerance < 1.5);
        CHECK(v.tolerance >= 1.5 * (1 - 20 * bounds::u));
    }
    SECTION("both errors are taken off") {
        const double e = 0x1p-20;
        REQUIRE(answers(1, 1, e, 0));
        CHECK(v.tolerance <= 0.5 * (1 - e));
        CHECK(v.tolerance >= 0.5 * (1 - e) * (1 - 20 * bounds::u));
        REQUIRE(answers(1, 1, 0, e));
        CHECK(v.tolerance <= 1 / (2 + e));
        CHECK(v.tolerance >= 1 / (2 + e) * (1 - 20 * bounds::u));
        REQUIRE(answers(1, 1, e, e));
        CHECK(v.tolerance <= (1 - e) / (2 + e));
        REQUIRE(answers(1, 1, e, e, false));
        CHECK(v.tolerance == 0.5);
    }
    SECTION("each error is at most the stated share") {
        CHECK(answers(1, 1, 0.99 * share, 0));
        CHECK(!answers(1, 1, share, 0));
        CHECK(!answers(1, 1, share, 0, false));
        CHECK(answers(1, 1, 0, 2 * 0.99 * share));
        CHECK(!answers(1, 1, 0, 2 * share));
        CHECK(answers(1, 1, 0, 2 * share, false));
    }
    SECTION("a sign needs more than the error") {
        CHECK(!answers(-1, 1, 1, 0));
        CHECK(!answers(0, 1, 0, 0));
        CHECK(!answers(0, 1, 1, 0));
        REQUIRE(answers(-1, 1, 0.99, 0));
        CHECK(v.sign == -1);
        CHECK(v.tolerance == 0.0);
    }
    SECTION("what is not a number is not an answer") {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        CHECK(!answers(nan, 1, 0, 0));
        CHECK(!answers(1, nan, 0, 0));
        CHECK(!answers(1, 1, nan, 0));
        CHECK(!answers(1, 1, 0, nan));
    }
}
