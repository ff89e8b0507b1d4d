// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>

namespace annulus {

/// Makes a call in which TBB has at most `threads` threads, that which calls among them.
template <class Call>
void in_arena(int threads, const Call& call) {
    // Asking for more than the machine has gains nothing, and oneTBB warns about it on stderr.
    oneapi::tbb::task_arena arena(std::min(threads, oneapi::tbb::info::default_concurrency()));
    arena.execute(call);
}

/// Calls run(first, last) for the indices below n in runs of `length`, by at most `threads` threads at once. Which
/// thread does which run is open: sums are to be kept by run and added in order.
template <class Run>
void for_each_run(std::size_t n, std::size_t length, int threads, const Run& run) {
    const std::size_t runs = (n + length - 1) / length;
    const auto one = [&](std::size_t r) { run(r * length, std::min(n, (r + 1) * length)); };
    if (threads == 1 || runs <= 1) {
        for (std::size_t r = 0; r < runs; ++r) one(r);
        return;
    }
    in_arena(threads, [&] { oneapi::tbb::parallel_for(std::size_t{0}, runs, one); });
}

}  // namespace annulus
