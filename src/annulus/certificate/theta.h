// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <algorithm>
#include <cmath>

namespace annulus {

/// The angle theta of a bi-cell in radians, in [0, pi/2]: the angle between the axis of the facet a b and the bisector
/// of the opposite vertices p, q (paper, figure 4). sin(theta) = |(q - p) . n| / (|q - p| |n|) with n normal to the
/// facet (theory 4). Small theta: the two lines whose crossing is the centre of the standard annulus are nearly
/// parallel. Plain double, accurate to a few units in the last place anywhere in the coordinate domain: the angle is
/// taken from sine and cosine together, of vectors scaled by powers of two. 0 when a = b or p = q.
[[nodiscard]] inline double theta(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& p,
                                  const Coordinates<2>& q) {
    double bx = b[0] - a[0];
    double by = b[1] - a[1];
    double ex = q[0] - p[0];
    double ey = q[1] - p[1];
    const auto normalise = [](double& x, double& y) {
        const double m = std::max(std::fabs(x), std::fabs(y));
        if (!(m > 0.0)) return;
        const int k = -std::ilogb(m);
        x = std::scalbn(x, k);
        y = std::scalbn(y, k);
    };
    normalise(bx, by);
    normalise(ex, ey);
    return std::atan2(std::fabs(bx * ey - by * ex), std::fabs(bx * ex + by * ey));
}

}  // namespace annulus
