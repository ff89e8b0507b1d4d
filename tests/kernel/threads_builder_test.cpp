// SPDX-License-Identifier: GPL-3.0-or-later
// Threads that build at once, also under ThreadSanitizer, by one builder whose buffers hold what it built before.
#include <annulus/kernel/builder.h>

#include <support/catch.h>
#include <support/small_sets.h>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
std::vector<Index> built(Builder<d>& builder, const std::vector<Coordinates<d>>& x, int threads) {
    std::vector<Index> all(x.size());
    std::iota(all.begin(), all.end(), Index{0});
    REQUIRE(builder.build(x, all, threads));
    Cell_table<d> table;
    builder.copy_to(table, x.size(), threads);
    std::vector<Index> numbers;
    for (const Cell_index c : table.cells())
        for (int i = 0; i <= d; ++i) {
            numbers.push_back(table.vertex(table.corner(c, i)));
            numbers.push_back(table.twin(table.corner(c, i)).value());
        }
    return numbers;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Threads that insert at once build what one thread builds, dimension", "[kernel][parallel]",
                       ((int d), d), 2, 3) {
    Random random(1);
    const auto x = small_set<d>(testing::Small_set::uniform, 20000, 0, random);
    Builder<d> builder;
    const auto alone = built<d>(builder, x, 1);
    for (const int threads : {2, 4}) CHECK((built<d>(builder, x, threads) == alone));
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
    const auto alone = built<2>(builder, x, 1);
    const auto order = builder.order();
    const auto rank = static_cast<std::size_t>(std::find(order.begin(), order.end(), corner) - order.begin());
    Random random(1);
    (void)built<2>(builder, small_set<2>(testing::Small_set::uniform, rank, 0, random), 2);
    CHECK((built<2>(builder, x, 2) == alone));
}
