// SPDX-License-Identifier: GPL-3.0-or-later
// A build that runs out of memory at any allocation: the same builder works again. With tiny limits the vertices are
// shared out among threads.
#include <support/built_numbers.h>
#include <support/failing_new.h>
#include <support/small_sets.h>

#include <numeric>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("A builder whose memory ran out builds again, whichever allocation failed, dimension",
                       "[allocation]", ((int d), d), 2, 3) {
    Random random(7);
    const auto x = small_set<d>(testing::Small_set::uniform, 120, 0, random);
    std::vector<Index> all(x.size());
    std::iota(all.begin(), all.end(), Index{0});
    Builder<d> fresh;
    const auto expected = built_numbers<d>(fresh, x, 1);
    for (const int threads : {1, 3})
        for (std::uint64_t n = 0;; ++n) {
            CAPTURE(d, threads, n);
            Builder<d> builder;
            const auto became = starve(n, Memory::short_once, [&] { (void)builder.build(std::span(x), all, threads); });
            REQUIRE((built_numbers<d>(builder, x, threads) == expected));
            if (became == Starved::done) break;
        }
}
