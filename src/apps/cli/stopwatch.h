// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace annulus::inline v1::cli {

using Clock = std::chrono::steady_clock;

/// Wall-clock seconds since `start`.
[[nodiscard]] inline double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace annulus::inline v1::cli
