// SPDX-License-Identifier: GPL-3.0-or-later
// filter_rounding_test.cpp for filter-each: what it writes down is rounded in the safe direction, to the last bit.

#include <engine/filter_session.h>

#include <support/catch.h>

#include <rapidcheck.h>

#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

REVEAL(Epsilon, &Paper_queue<2>::epsilon_);
REVEAL(Each_position, &Paper_queue<2>::position_);
REVEAL(Lower, &Paper_queue<2>::lower);
REVEAL(Each_passes, &Paper_queue<2>::passes);

}  // namespace

TEST_CASE("filter-each: what passes is nearer to its fixed position than its tolerance", "[relocation][rounding]") {
    REQUIRE(rc::check("of tolerances of any magnitude", [](const Seed& seed) {
        Random random = seed.random();
        Session<Paper_queue<2>> s(random);
        for (int i = 0; i < 500; ++i) {
            const auto v = static_cast<Index>(random() % s.points.size());
            const double tolerance = std::ldexp(1.0 + unit(random), integer(random, -30, 0));
            s[Epsilon{}][at(v)] = HUGE_VAL;
            s.call(Lower{}, v, tolerance);
            // As far as that, up to rounding, in some direction.
            const Point& f = s.filter.fixed_position(v);
            const double angle = between(random, 0.0, 6.3);
            Point& p = s[Each_position{}][at(v)];
            p = {f[0] + tolerance * std::cos(angle), f[1] + tolerance * std::sin(angle)};
            if (random() % 2 == 0) p[random() % 2] = f[random() % 2 == 0 ? 0 : 1];
            if (p != f && s.call(Each_passes{}, v))
                RC_ASSERT(exact_squared_distance(p, f) < Rational(tolerance) * Rational(tolerance));
        }
    }));
}
