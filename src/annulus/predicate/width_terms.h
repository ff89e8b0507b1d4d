// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/exact.h>
#include <annulus/arithmetic/interval.h>
#include <annulus/predicate/vector.h>

#include <algorithm>

namespace annulus::inline v1 {

/// The terms of half a width: half width = determinant / (sqrt(inner) + sqrt(outer)).
///
/// The sign of the certificate is the sign of `determinant`. There is one formula per quantity, written once for
/// doubles, intervals and integers. The centre of the annulus, whose division by D fails when theta goes to 0, never
/// appears.
template <class T>
struct Width_terms {
    T determinant;
    T inner;
    T outer;
};

/// Half the least altitude of the triangle 0, u, v, where w = v - u; positive when the triangle is.
///
/// The three points can become collinear under a displacement of each by s exactly when a slab of width 2s holds them,
/// and the width of the least such slab is the least altitude 2A / max side (theory 2; paper 2.2 "parallel
/// hyperplanes"). Here determinant = u x v = 2A and inner = outer = max side squared, so the quotient is A / max side,
/// half an altitude.
template <class T>
[[nodiscard]] Width_terms<T> orientation_terms(const Vector_2<T>& u, const Vector_2<T>& v, const Vector_2<T>& w) {
    using std::max;
    const T det = u.x * v.y - u.y * v.x;
    const T uu = squared(u.x) + squared(u.y);
    const T vv = squared(v.x) + squared(v.y);
    const T ww = squared(w.x) + squared(w.y);
    const T longest = max(max(uu, vv), ww);
    return {det, longest, longest};
}

/// Half the width of the standard annulus of the edge a b with opposite vertices p (right of ab) and q (left of it):
///
///               . - - - - .
///           .                 .
///         .     . - b - .       .        inner circle: through a and b, radius |N| / 2D
///        .     .    |    .       .
///       q<-w->.     |o    .<-w->p        o: the common centre, where the bisectors of a b and p q meet
///        .     .    |    .       .
///         .     . - a - .       .        outer circle: through p and q, radius |M| / 2D
///           .                 .
///               . - - - - .              the tolerance is w / 2
///
/// Vectors b, p, q are relative to a, and e = q - p. With ob = b x q and oa = p x b (both positive), D = ob + oa,
/// s = e.(q + p - b), the vector N = D b + s b_perp is 2D times the centre, M = N - 2 D p, and
/// |M|^2 - |N|^2 = 4 D incircle, so (|M| - |N|) / 2D / 2 = incircle / (|M| + |N|) (theory 4; proofs/coq/width_2.v).
template <class T>
[[nodiscard]] Width_terms<T> annulus_terms(const Vector_2<T>& b, const Vector_2<T>& p, const Vector_2<T>& q,
                                           const Vector_2<T>& e) {
    const T ob = b.x * q.y - b.y * q.x;
    const T oa = b.y * p.x - b.x * p.y;
    const T D = ob + oa;
    const T gx = (q.x + p.x) - b.x;
    const T gy = (q.y + p.y) - b.y;
    const T s = e.x * gx + e.y * gy;
    const T nx = D * b.x - s * b.y;
    const T ny = D * b.y + s * b.x;
    const T twice_D = D + D;
    const T mx = nx - twice_D * p.x;
    const T my = ny - twice_D * p.y;
    const T kp = p.x * (p.x - b.x) + p.y * (p.y - b.y);
    const T kq = q.x * (q.x - b.x) + q.y * (q.y - b.y);
    const T incircle = kp * ob + kq * oa;
    const T inner = squared(nx) + squared(ny);
    const T outer = squared(mx) + squared(my);
    return {incircle, inner, outer};
}

}  // namespace annulus::inline v1
