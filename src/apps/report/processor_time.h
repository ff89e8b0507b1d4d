// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <time.h>

namespace annulus::inline v1 {

/// Processor time of this thread in seconds: the time in which other processes run does not count.
[[nodiscard]] inline double processor_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The same for all threads of the process.
[[nodiscard]] inline double process_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace annulus::inline v1
