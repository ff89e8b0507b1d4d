// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <latch>
#include <thread>
#include <vector>

namespace annulus::testing {

/// The results of four threads that run at the same time.
template <class Say>
auto at_once(const Say& say) {
    constexpr int threads = 4;
    std::vector<decltype(say())> said(threads);
    std::latch start(threads);
    std::vector<std::thread> all;
    for (int t = 0; t < threads; ++t)
        all.emplace_back([&, t] {
            start.arrive_and_wait();
            said[static_cast<std::size_t>(t)] = say();
        });
    for (std::thread& t : all) t.join();
    return said;
}

}  // namespace annulus::testing
