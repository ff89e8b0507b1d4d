// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/available_threads.h>

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// Runs a call in which TBB has at most `threads` threads, the calling one included; one thread if the system does not
/// provide that many.
template <class Call>
void in_arena(int threads, const Call& call) {
    // Asking for more than the machine has gains nothing, and oneTBB warns about it on stderr.
    oneapi::tbb::task_arena arena(available_threads(threads));
    arena.execute(call);
}

/// Calls run(first, last) for the indices below n in runs of `length`, by at most `threads` threads at once. The
/// assignment of runs to threads is not determined: keep sums by run and add them in order.
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

/// Fills slots by fill(slot) until it returns false, calls work(slot) for each, on at most `threads` threads at once,
/// and then take(slot), in the order in which they were filled. At most one call of fill and one of take runs at a
/// time, on any thread: sums made by take do not depend on the number of threads. There are a few slots for each
/// thread, and they are reused.
template <class Slot, class Fill, class Work, class Take>
void for_each_in_order(int threads, const Fill& fill, const Work& work, const Take& take) {
    namespace tbb = oneapi::tbb;
    if (threads == 1) {
        for (Slot slot; fill(slot);) {
            work(slot);
            take(slot);
        }
        return;
    }
    std::vector<Slot> slots(4 * static_cast<std::size_t>(std::min(threads, tbb::info::default_concurrency())));
    std::size_t filled = 0;
    const auto first = [&](tbb::flow_control& flow) -> Slot* {
        // The slot filled slots.size() calls ago has been taken: those in use are consecutive.
        Slot& slot = slots[filled++ % slots.size()];
        if (fill(slot)) return &slot;
        flow.stop();
        return nullptr;
    };
    const auto second = [&](Slot* slot) {
        work(*slot);
        return slot;
    };
    const auto third = [&](Slot* slot) { take(*slot); };
    in_arena(threads, [&] {
        tbb::parallel_pipeline(slots.size(),
                               tbb::make_filter<void, Slot*>(tbb::filter_mode::serial_in_order, first) &
                                   tbb::make_filter<Slot*, Slot*>(tbb::filter_mode::parallel, second) &
                                   tbb::make_filter<Slot*, void>(tbb::filter_mode::serial_in_order, third));
    });
}

}  // namespace annulus::inline v1
