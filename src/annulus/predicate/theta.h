// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/euclidean.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace annulus::inline v1 {

/// The angle theta of a bi-cell in radians, in [0, pi/2]: the angle between the axis of the facet a b and the bisector
/// of the opposite vertices p, q (paper, figure 4). sin(theta) = |(q - p) . n| / (|q - p| |n|) with n normal to the
/// facet (theory 4). For small theta the two lines whose crossing is the centre of the standard annulus are nearly
/// parallel. Plain double, accurate to a few units in the last place anywhere in the coordinate domain: the angle is
/// computed from sine and cosine together, of vectors scaled by powers of two. 0 when a = b or p = q.
[[nodiscard]] inline double theta(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& p,
                                  const Coordinates<2>& q) {
    auto [bx, by] = Euclidean<2>::difference(b, a);
    auto [ex, ey] = Euclidean<2>::difference(q, p);
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

/// The same in 3D: the angle between the axis of the facet a b c and the bisector of p, q. Accurate to a few units in
/// the last place, divided by the sine of the facet's least angle, because the normal of a thin facet is known no
/// better; anywhere in the coordinate domain. 0 when p = q or a, b, c are collinear.
[[nodiscard]] inline double theta(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                  const Coordinates<3>& p, const Coordinates<3>& q) {
    using Vector = std::array<double, 3>;
    const auto normalised = [](Vector v) {
        const double m = std::max(std::max(std::fabs(v[0]), std::fabs(v[1])), std::fabs(v[2]));
        if (!(m > 0.0)) return v;
        const int k = -std::ilogb(m);
        for (double& x : v) x = std::scalbn(x, k);
        return v;
    };
    const auto cross = [](const Vector& u, const Vector& v) {
        return Vector{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    };
    const Vector e = normalised(Euclidean<3>::difference(q, p));
    const Vector n =
        normalised(cross(normalised(Euclidean<3>::difference(b, a)), normalised(Euclidean<3>::difference(c, a))));
    const Vector sine = cross(e, n);
    const double along = std::fabs(e[0] * n[0] + e[1] * n[1] + e[2] * n[2]);
    return std::atan2(along, std::hypot(sine[0], sine[1], sine[2]));
}

}  // namespace annulus::inline v1
