// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <algorithm>
#include <cmath>

namespace annulus {

/// The angle theta of a bi-cell in radians, in [0, pi/2]: the angle between the axis of the facet a b and the bisector
/// of the opposite vertices p, q (paper, figure 4). sin(theta) = |(q - p) . n| / (|q - p| |n|) with n normal to the
/// facet (theory 4). Small theta: the two lines whose crossing is the centre of the standard annulus are nearly
/// parallel. Plain double, accurate to a few units in the last place of the sine unless q - p is nearly normal to n.
[[nodiscard]] inline double theta(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& p,
                                  const Coordinates<2>& q) {
    const double bx = b[0] - a[0];
    const double by = b[1] - a[1];
    const double ex = q[0] - p[0];
    const double ey = q[1] - p[1];
    const double lengths = std::hypot(bx, by) * std::hypot(ex, ey);
    if (!(lengths > 0.0)) return 0.0;
    const double sine = std::fabs(bx * (ey / lengths) - by * (ex / lengths));
    return std::asin(std::min(1.0, sine));
}

}  // namespace annulus
