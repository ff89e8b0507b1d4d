// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/orientation_sign.h>
#include <annulus/space/places.h>

namespace annulus::inline v1 {

/// The exact orientation of d + 1 points: by the filter, and by the exact stage where the filter cannot decide. The
/// rounding mode must be to nearest.
template <int d>
[[nodiscard]] int sure_orientation(const Tuple<d, d + 1>& x) {
    const int sign = orientation_sign(x);
    return sign != 0 ? sign : exact_orientation_sign(x).sign;
}

}  // namespace annulus::inline v1
