// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/width_terms_3.h>

namespace annulus::inline v1 {

// The determinant of an empty circle or sphere, with the part of the cell computed first: one formula for doubles, four
// of them side by side, intervals and integers. The order of operations is part of what is proved
// (proofs/gappa/circumcircle_2.g, circumsphere_3.g). Always inlined: an operation on four doubles has no instruction
// on the baseline of the target (mesh/four_cells.h).

/// Of a triangle or a cell with one corner at 0.
template <class Vector, class T>
struct Sphere_terms {
    Vector normal;
    T determinant;  ///< twice the area, six times the volume; positive when the cell is
};

/// The triangle 0, u, v: | u |u|^2 |, | v |v|^2 | and | w |w|^2 | have the determinant w . normal + |w|^2 determinant.
template <class T>
[[nodiscard, gnu::always_inline]] inline Sphere_terms<Vector_2<T>, T> sphere_terms(const Vector_2<T>& u,
                                                                                   const Vector_2<T>& v) {
    const T uu = squared(u.x) + squared(u.y);
    const T vv = squared(v.x) + squared(v.y);
    return {{T(u.y * vv - v.y * uu), T(v.x * uu - u.x * vv)}, T(u.x * v.y - u.y * v.x)};
}
/// Positive when w is outside the circle of a positive triangle.
template <class T>
[[nodiscard, gnu::always_inline]] inline T sphere_determinant(const Vector_2<T>& normal, const T& determinant,
                                                              const Vector_2<T>& w) {
    const T ww = squared(w.x) + squared(w.y);
    return (w.x * normal.x + w.y * normal.y) + ww * determinant;
}

/// The cell 0, u, v, t: the same in 3D. The determinant is |w|^2 determinant - w . normal, and normal / (2 determinant)
/// is where the centre is.
template <class T>
[[nodiscard, gnu::always_inline]] inline Sphere_terms<Vector_3<T>, T> sphere_terms(const Vector_3<T>& u,
                                                                                   const Vector_3<T>& v,
                                                                                   const Vector_3<T>& t) {
    const Vector_3<T> uv = cross(u, v);
    const Vector_3<T> vt = cross(v, t);
    const Vector_3<T> tu = cross(t, u);
    const T uu = square(u);
    const T vv = square(v);
    const T tt = square(t);
    return {{T((uu * vt.x + vv * tu.x) + tt * uv.x), T((uu * vt.y + vv * tu.y) + tt * uv.y),
             T((uu * vt.z + vv * tu.z) + tt * uv.z)},
            dot(uv, t)};
}
template <class T>
[[nodiscard, gnu::always_inline]] inline T sphere_determinant(const Vector_3<T>& normal, const T& determinant,
                                                              const Vector_3<T>& w) {
    return square(w) * determinant - dot(w, normal);
}

}  // namespace annulus::inline v1
