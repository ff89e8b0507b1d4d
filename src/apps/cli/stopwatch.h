// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/processor_time.h>

#include <chrono>

namespace annulus::inline v1::cli {

using Clock = std::chrono::steady_clock;

/// Wall-clock seconds since `start`.
[[nodiscard]] inline double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Seconds since it was made: with one thread of the processor, for which pauses of the machine do not count, with more
/// of the wall clock. To be read in the thread in which it was made.
class Stopwatch {
  public:
    /// `threads`: how many what is timed may use.
    explicit Stopwatch(int threads) : alone_(threads == 1), processor_(alone_ ? processor_seconds() : 0) {}
    [[nodiscard]] double seconds() const { return alone_ ? processor_seconds() - processor_ : since(start_); }

  private:
    bool alone_;
    double processor_;
    Clock::time_point start_ = Clock::now();
};

}  // namespace annulus::inline v1::cli
