// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/wide_integer.h>

#include <cmath>

namespace annulus::inline v1 {

/// The multiple of 1 nearest to the sum of terms, halves upward: exactly while fractions of the terms are multiples of
/// 2^-47, otherwise up to 2^-47 of a unit.
struct Rounded_sum {
    Int128 whole = 0;
    double fraction = 0;

    void add(double term) {
        const double below = std::floor(term);
        whole += static_cast<Int128>(below);
        fraction += term - below;
    }
    [[nodiscard]] Int128 nearest() const { return whole + static_cast<Int128>(std::floor(fraction + 0.5)); }
};

/// The multiple of `grid`, a power of two, nearest to x.
[[nodiscard]] inline double rounded(double x, double grid) {
    Rounded_sum sum;
    sum.add(x / grid);
    return static_cast<double>(sum.nearest()) * grid;
}

}  // namespace annulus::inline v1
