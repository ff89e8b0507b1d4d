// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace annulus::inline v1::cli {

/// The standard deviation of volumes over their mean, of those that are finite numbers; 0 of none. Linear.
[[nodiscard]] inline double scatter_of(const std::vector<double>& volumes) {
    double sum = 0, squares = 0;
    std::size_t n = 0;
    for (const double v : volumes)
        if (std::isfinite(v)) {
            sum += v;
            ++n;
        }
    if (!(sum > 0)) return 0;
    const double mean = sum / static_cast<double>(n);
    for (const double v : volumes)
        if (std::isfinite(v)) squares += (v / mean - 1) * (v / mean - 1);
    return std::sqrt(squares / static_cast<double>(n));
}

}  // namespace annulus::inline v1::cli
