// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>

namespace annulus::inline v1 {

/// a . b rounded to nearest at every step.
template <int d>
[[nodiscard]] inline double dot(const Coordinates<d>& a, const Coordinates<d>& b) {
    double sum = 0.0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) sum += a[k] * b[k];
    return sum;
}

}  // namespace annulus::inline v1
