// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that build at once, by one builder whose buffers hold what it built before; over tiny limits also under
// ThreadSanitizer, with as many parts and rounds of fewer points.
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
    const auto x = small_set<d>(testing::Small_set::uniform, Limits::tiny ? 3000 : 20000, 0, random);
    Builder<d> builder;
    const auto alone = built_numbers<d>(builder, x, 1);
    for (const int threads : {2, 4}) CHECK((built_numbers<d>(builder, x, threads) == alone));
}

// The last round has more than 64 shares of Limits::shared_part vertices; 64 parts are the most.
TEST_CASE("More threads than parts build what one thread builds", "[kernel][parallel]") {
    Random random(3);
    const auto x = small_set<2>(testing::Small_set::uniform, Limits::tiny ? 2000 : 320000, 0, random);
    Builder<2> builder;
    const auto alone = built_numbers<2>(builder, x, 1);
    CHECK((built_numbers<2>(builder, x, 300) == alone));
}

// All cells are at that vertex, or at infinity, and it belongs to no part in the rounds before its own. With assertions
// of the standard library, as with sanitizers, the test also fails where one is read.
TEST_CASE("A corner of the first cell that is of a later round is in the part of no thread", "[kernel][parallel]") {
    constexpr std::size_t n = Limits::tiny ? 900 : 90000;
    std::vector<Coordinates<2>> x(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = {static_cast<double>(i), 0};
    std::vector<Index> all(n);
    std::iota(all.begin(), all.end(), Index{0});
    Builder<2> builder;
    REQUIRE(!builder.build(x, all));
    const Index corner = builder.order()[n / 3 * 2];  // of the last round, which has seven eighths
    x[static_cast<std::size_t>(corner)][1] = 0.25;
    const auto alone = built_numbers<2>(builder, x, 1);
    const auto order = builder.order();
    const auto rank = static_cast<std::size_t>(std::find(order.begin(), order.end(), corner) - order.begin());
    Random random(1);
    (void)built_numbers<2>(builder, small_set<2>(testing::Small_set::uniform, rank, 0, random), 2);
    CHECK((built_numbers<2>(builder, x, 2) == alone));
}
