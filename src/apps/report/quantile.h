// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// The value that a share of these are below, between two of them by linear interpolation, like NumPy's. Reorders
/// them. Precondition: there is one, and 0 <= share <= 1. O(n).
[[nodiscard]] inline double quantile(std::vector<double>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(values.begin(), at, values.end());
    const double rest = place - std::floor(place);
    return rest == 0 ? *at : *at + rest * (*std::min_element(at + 1, values.end()) - *at);
}

}  // namespace annulus::inline v1
