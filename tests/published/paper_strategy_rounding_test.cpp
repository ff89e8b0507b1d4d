// SPDX-License-Identifier: GPL-3.0-or-later
// As tolerance_strategy_rounding_test.cpp, for the strategy `paper`: numbers that it stores are rounded in the safe
// direction, to the last bit.

#include <engine/strategy_session.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

REVEAL(State_of, &Paper_strategy<2>::state_);
REVEAL(Moving_position, &Paper_strategy<2>::position_);
REVEAL(Lower, &Paper_strategy<2>::lower);
REVEAL(Paper_passes, &Paper_strategy<2>::passes);

}  // namespace

TEST_CASE("paper: what passes is nearer to its fixed position than its tolerance", "[relocation][rounding]") {
    REQUIRE(for_all("of tolerances of any magnitude", [](const Seed& seed) {
        Random random = seed.random();
        Session<Paper_strategy<2>> s(random, Paper_choice{}, Tolerance_kind::floating, 0U);
        for (int i = 0; i < 500; ++i) {
            const auto v = static_cast<Index>(random() % s.points.size());
            const double tolerance = std::ldexp(1.0 + unit(random), integer(random, -30, 0));
            s[State_of{}].epsilon[at(v)] = HUGE_VAL;
            s.call(Lower{}, v, tolerance);
            // As far as that, up to rounding, in some direction.
            const Point& f = s.strategy.fixed_position(v);
            const double angle = between(random, 0.0, 6.3);
            Point& p = s[Moving_position{}][at(v)];
            p = {f[0] + tolerance * std::cos(angle), f[1] + tolerance * std::sin(angle)};
            if (random() % 2 == 0) p[random() % 2] = f[random() % 2 == 0 ? 0 : 1];
            if (p != f && s.call(Paper_passes{}, v))
                RC_ASSERT(exact_squared_distance(p, f) < Rational(tolerance) * Rational(tolerance));
        }
    }));
}
