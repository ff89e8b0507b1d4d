// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <time.h>

namespace bench {

/// Processor time of this thread, which excludes the time of other processes: steadier than a clock on a shared
/// machine. For several threads only the clock is available.
class Stopwatch {
  public:
    explicit Stopwatch(int threads = 1) : clock_(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC) {}
    [[nodiscard]] double seconds() const {
        timespec t{};
        clock_gettime(clock_, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    }

  private:
    clockid_t clock_;
};

}  // namespace bench
