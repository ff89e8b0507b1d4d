// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

/// The nearest double to a measure; the largest one for what is larger.
[[nodiscard]] inline double saturated(long double x) {
    return static_cast<double>(std::min(x, static_cast<long double>(std::numeric_limits<double>::max())));
}

}  // namespace annulus::inline v1
