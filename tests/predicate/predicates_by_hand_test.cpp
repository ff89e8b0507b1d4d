// SPDX-License-Identifier: GPL-3.0-or-later
// The public predicates of a few points by hand, and points that they refuse.
#include <annulus/error.h>
#include <annulus/predicates.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("Predicates of a few points by hand", "[predicates]") {
    CHECK(int{orient_2d({0, 0}, {1, 0}, {0, 1}).sign} == 1);
    CHECK(int{orient_3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}).sign} == 1);
    CHECK(orient_2d({0, 0}, {8, 0}, {4, 2}).tolerance == Approx(1.0));
    // A square: both diagonals are bi-cells.
    const Certified_sign square = in_circle({0, 0}, {1, 0}, {1, 1}, {0, 1});
    CHECK(int{square.sign} == 0);
    CHECK(square.theta == Approx(1.5707963267948966));
    // A rhombus with diagonals 2 and 2 h. The annulus around its centre has the radii 1 and h < 1.
    const double h = 0.75;
    const Certified_sign rhombus = in_circle({-1, 0}, {0, -h}, {1, 0}, {0, h});
    CHECK(int{rhombus.sign} == 1);
    CHECK(rhombus.width_lower == Approx(1 - h));
    CHECK(rhombus.tolerance == Approx((1 - h) / 2));
    CHECK(rhombus.theta == Approx(1.5707963267948966));
    CHECK(rhombus.stage == Stage::filter);
    CHECK(int{in_circle({0, -h}, {-1, 0}, {1, 0}, {0, h}).sign} == -1);
    // Points on a sphere, in a plane, at one position.
    CHECK(int{in_sphere({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}).sign} == 0);
    CHECK(int{in_sphere({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, 0}).sign} ==
          int{orient_3d({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}).sign});
    CHECK(in_circle({0, 0}, {1, 1}, {2, 2}, {3, 3}).theta == 0);
    CHECK(int{in_circle({0, 0}, {0, 0}, {2, 2}, {3, 5}).sign} == 0);
}

TEST_CASE("Predicates refuse points outside the domain, and name them", "[predicates]") {
    const double inf = std::numeric_limits<double>::infinity();
    const auto refused = [](const auto& f) -> std::optional<Error> {
        try {
            f();
        } catch (const Error& e) {
            return e;
        }
        return {};
    };
    auto e = refused([&] { (void)in_circle({0, 0}, {1, 0}, {std::nan(""), 1}, {1, 1}); });
    REQUIRE(e);
    CHECK(e->code() == Error_code::not_finite);
    CHECK(e->vertices()[0] == 2);
    e = refused([&] { (void)orient_3d({0, 0, 0}, {1, 0, 0}, {0, 0x1.1p500, 0}, {0, inf, 1}); });
    REQUIRE(e);
    CHECK(e->code() == Error_code::out_of_domain);
    CHECK(e->vertices()[0] == 2);
    std::vector<std::array<Coordinates<2>, 3>> rows(3, {Coordinates<2>{0, 0}, {1, 0}, {0, 1}});
    rows[1][2][0] = inf;
    std::vector<Certified_sign> out(3);
    e = refused([&] { orient_2d(rows, out); });
    REQUIRE(e);
    CHECK(e->code() == Error_code::not_finite);
    CHECK(e->vertices()[0] == 1);
    std::fesetround(FE_UPWARD);
    e = refused([&] { (void)orient_2d({0, 0}, {1, 0}, {0, 1}); });
    std::fesetround(FE_TONEAREST);
    REQUIRE(e);
    CHECK(e->code() == Error_code::environment);
}
