// SPDX-License-Identifier: GPL-3.0-or-later
// The stored worst cases still reach their values, bit for bit, and are within the bounds.
#include "worst_cases.h"

#include <support/catch.h>

#include <cstdlib>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("The worst cases kept of every climb reach what they reached, and no more than the bound",
          "[certificate][space]") {
    for (const Climb& climb : climbs()) {
        CAPTURE(climb.name);
        CHECK(greatest_kept(climb.name) > 0);
    }
    for (const Worst_case& w : worst_cases()) {
        CAPTURE(w.climb);
        const auto climb =
            std::find_if(climbs().begin(), climbs().end(), [&](const Climb& c) { return c.name == w.climb; });
        REQUIRE(climb != climbs().end());
        REQUIRE(w.x.size() == climb->size);
        CHECK(climb->value(w.x) == w.reached);
        CHECK(w.reached <= climb->bound);
    }
}

TEST_CASE("Climbs from the kept worst cases and from anywhere print what is worse", "[.climb]") {
    Random random(run_seed());
    const char* given = std::getenv("ANNULUS_CLIMB_STEPS");
    const int steps = given != nullptr ? std::atoi(given) : 20000;
    for (const Climb& climb : climbs()) {
        const std::size_t dimension = climb.size % 3 == 0 && climb.size > 6 ? 3 : 2;
        Numbers best;
        double most = 0;
        for (int again = 0; again < 4; ++again) {
            Numbers x = start(climb.size, dimension, random);
            if (again == 3)
                for (const Worst_case& w : worst_cases())
                    if (w.climb == climb.name) x = w.x;
            const double reached = annulus::testing::climb(x, 1.5, random, steps / 4, climb.value);
            if (reached > most) most = reached, best = x;
        }
        CHECK(most <= climb.bound);
        (void)report_if_worse(climb.name, most, best);
    }
}
