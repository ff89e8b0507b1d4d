// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>

namespace annulus::inline v1 {

/// |a - b|^2 rounded to nearest at every step: at most 1 + 6u times the truth, unless it underflows below 2^-1022.
template <int d>
[[nodiscard]] inline double squared_distance(const Coordinates<d>& a, const Coordinates<d>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
        const double c = a[k] - b[k];
        sum += c * c;
    }
    return sum;
}

}  // namespace annulus::inline v1
