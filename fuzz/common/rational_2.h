// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Half widths in 2D from their definitions, in rational numbers: altitudes, and the centre where two bisectors
// meet. Nothing here calls the library.

#include "rational_3.h"

namespace annulus::oracle {

/// As a 3D vector.
[[nodiscard]] inline Vector_q between(const Coordinates<2>& from, const Coordinates<2>& to) {
    return {mpq_class(to[0]) - mpq_class(from[0]), mpq_class(to[1]) - mpq_class(from[1]), mpq_class(0)};
}
/// Twice the area of a, b, c where they turn left.
[[nodiscard]] inline mpq_class turn(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
    return cross(between(a, b), between(a, c))[2];
}

/// The altitude of x[2] over the line through x[0] and x[1].
[[nodiscard]] inline Half_width_3 altitude(const Tuple<2, 3>& x) {
    const Vector_q side = between(*x[0], *x[1]);
    Half_width_3 h(sgn(turn(*x[0], *x[1], *x[2])));
    h.add_slab({mpq_class(-side[1]), side[0], mpq_class(0)}, between(*x[0], *x[2]));
    return h;
}
/// The least of the three.
[[nodiscard]] inline Half_width_3 simplex(const Tuple<2, 3>& x) {
    Half_width_3 h = altitude(x);
    h.add(altitude({x[1], x[2], x[0]}));
    h.add(altitude({x[2], x[0], x[1]}));
    return h;
}

/// The annulus of x = {a, b, p, q}, through a and b and through p and q; both triangles are positive. Positive when
/// the circle of a, b, q leaves p outside.
[[nodiscard]] inline Half_width_3 annulus_2(const Tuple<2, 4>& x) {
    const Vector_q b = between(*x[0], *x[1]), p = between(*x[0], *x[2]), q = between(*x[0], *x[3]);
    // c . b = |b|^2 / 2 and c . (q - p) = (|q|^2 - |p|^2) / 2, relative to a. As p and q are on different sides of b,
    // det > 0.
    const Vector_q e = between(*x[2], *x[3]);
    const mpq_class det = b[0] * e[1] - b[1] * e[0];
    const mpq_class r = dot(b, b) / 2, s = (dot(q, q) - dot(p, p)) / 2;
    const Vector_q c{(r * e[1] - b[1] * s) / det, (b[0] * s - r * e[0]) / det, 0};
    const mpq_class inner = dot(c, c);
    const Vector_q to_p{p[0] - c[0], p[1] - c[1], 0};
    const mpq_class outer = dot(to_p, to_p);
    Half_width_3 h(sgn(mpq_class(outer - inner)));
    h.add_annulus(inner, outer);
    return h;
}

}  // namespace annulus::oracle
