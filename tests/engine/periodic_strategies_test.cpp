// SPDX-License-Identifier: GPL-3.0-or-later
// Strategies of periodic boxes: which of them keeps tolerances, and their names.
#include <annulus/options.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/moving_box.h>
#include <support/periodic_boxes.h>
#include <support/safe_tolerances.h>

#include <cstddef>
#include <cstdint>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("Tolerances of a strategy that keeps none are those of all certificates", "[engine][periodic]") {
    Periodic_cases cases(4);
    Moving_box<3> motion(Moving::jitter, 4, 60, 1e-4);
    Periodic_mesh<3> kept(motion.points(), motion.box(), {.strategy = Periodic_strategy::tolerances});
    Periodic_mesh<3> by_signs(motion.points(), motion.box(), {.strategy = Periodic_strategy::signs});
    for (int k = 0; k < 4; ++k) {
        motion.advance();
        (void)kept.move_all(motion.points(), motion.box());
        CHECK(by_signs.move_all(motion.points(), motion.box()).statistics.tolerance_recomputations == 0);
        expect_safe_tolerances(by_signs, cases);
        const auto left = kept.tolerances(), all = by_signs.tolerances();
        double sum_left = 0, sum_all = 0;
        for (std::size_t v = 0; v < all.size(); ++v) {
            sum_left += left[v];
            sum_all += all[v];
        }
        CHECK(2 * sum_left > sum_all);
    }
}

TEST_CASE("By default tolerances are kept while they pay", "[engine][periodic]") {
    Moving_box<3> slow(Moving::strain, 0, 600, 1e-6), fast(Moving::jitter, 0, 600, 0.2);
    Periodic_mesh<3> mesh(slow.points(), slow.box());
    std::uint64_t by_tolerances = 0, by_signs = 0;
    for (int k = 0; k < 20; ++k) {
        slow.advance();
        by_tolerances += mesh.move_all(slow.points(), slow.box()).statistics.tolerance_steps;
    }
    CHECK(by_tolerances >= 18);
    Periodic_mesh<3> rapid(fast.points(), fast.box());
    for (int k = 0; k < 10; ++k) {
        fast.advance();
        by_signs += rapid.move_all(fast.points(), fast.box()).statistics.sign_steps;
    }
    CHECK(by_signs == 10);
}

TEST_CASE("Strategies of periodic boxes have names", "[engine][periodic]") {
    for (const Periodic_strategy s :
         {Periodic_strategy::automatic, Periodic_strategy::signs, Periodic_strategy::tolerances})
        CHECK(periodic_strategy_named(name_of(s)) == s);
    CHECK(!periodic_strategy_named("rebuild"));
}
