// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that build at once, also under ThreadSanitizer, by one builder whose buffers hold what it built before.
#include <support/built_numbers.h>
#include <support/small_sets.h>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("Threads that insert at once build what one thread builds, dimension", "[kernel][parallel]",
                       ((int d), d), 2, 3) {
    Random random(1);
    const auto x = small_set<d>(testing::Small_set::uniform, 20000, 0, random);
    Builder<d> builder;
    const auto alone = built_numbers<d>(builder, x, 1);
    for (const int threads : {2, 4}) CHECK((built_numbers<d>(builder, x, threads) == alone));
}

// The last round has more than 64 shares of 4,096 vertices; 64 parts are the most.
TEST_CASE("More threads than parts build what one thread builds", "[kernel][parallel]") {
    Random random(3);
    const auto x = small_set<2>(testing::Small_set::uniform, 320000, 0, random);
    Builder<2> builder;
    const auto alone = built_numbers<2>(builder, x, 1);
    CHECK((built_numbers<2>(builder, x, 300) == alone));
}

// All cells are at that vertex, or at infinity. Its rank was that of infinity before, which is in each thread's territory.
TEST_CASE("A corner of the first cell that is of a later round is in no thread's territory", "[kernel][parallel]") {
    std::vector<Coordinates<2>> x(90000);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = {static_cast<double>(i), 0};
    std::vector<Index> all(x.size());
    std::iota(all.begin(), all.end(), Index{0});
    Builder<2> builder;
    REQUIRE(!builder.build(x, all));
    const Index corner = builder.order()[60000];  // of the last round, which has seven eighths
    x[static_cast<std::size_t>(corner)][1] = 0.25;
    const auto alone = built_numbers<2>(builder, x, 1);
    const auto order = builder.order();
    const auto rank = static_cast<std::size_t>(std::find(order.begin(), order.end(), corner) - order.begin());
    Random random(1);
    (void)built_numbers<2>(builder, small_set<2>(testing::Small_set::uniform, rank, 0, random), 2);
    CHECK((built_numbers<2>(builder, x, 2) == alone));
}
