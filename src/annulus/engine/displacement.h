// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/squared_distance.h>
#include <annulus/types.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

/// An upper bound of |a - b|, tight to a few units in the last place where squares do not underflow.
template <int d>
[[nodiscard]] inline double distance_upper(const Coordinates<d>& a, const Coordinates<d>& b) {
    const double squares = squared_distance<d>(a, b);
    if (squares > 0x1p-900) return std::sqrt(squares) * (1.0 + 0x1p-49);
    double sum = 0.0;  // |a - b|_2 <= |a - b|_1; differences of doubles are exact when subnormal
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) sum += std::fabs(a[k] - b[k]);
    return sum * (1.0 + 0x1p-49);
}

/// A number S such that squared_distance(a, b) < S implies |a - b| < radius. It is the square rounded down past the
/// errors of both sides, so the comparison needs no square root and no directed rounding. It is 0, which nothing is
/// below, where squares could underflow (radius under 2^-450) and for radius <= 0.
[[nodiscard]] inline double squared_threshold_lower(double radius) {
    if (!(radius > 0x1p-450)) return 0.0;
    if (radius > 0x1p510) return 0x1p1020;  // beyond the diameter of the coordinate domain
    // (1 - 2^-49) covers the square (u), this product (u) and the six roundings of squared_distance.
    return radius * radius * (1.0 - 0x1p-49);
}

/// a + b rounded down past the error of the addition; a, b >= 0.
[[nodiscard]] inline double sum_lower(double a, double b) {
    const double s = a + b;
    return s - s * 0x1p-52;
}
[[nodiscard]] inline double sum_upper(double a, double b) {
    const double s = a + b;
    return s + s * 0x1p-52;
}

}  // namespace annulus::inline v1
