// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/certificate_value.h>
#include <annulus/predicate/decide.h>
#include <annulus/predicate/width_terms.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace detail {

/// The filter stage of an orientation, from the rounded differences of its points: u = x1 - x0, v = x2 - x0,
/// w = x2 - x1.
template <class V>
[[nodiscard]] Decision<V> decide_orientation(const Vector_2<V>& u, const Vector_2<V>& v, const Vector_2<V>& w,
                                             bool certified) {
    using std::max;
    using std::sqrt;
    const V m = max(magnitude(u), magnitude(v));
    const auto t = orientation_terms(u, v, w);
    // The sides are each relative to u, so the norms have relative errors only: no absolute norm error.
    return in_range(m, bounds::filter_range,
                    decide(t.determinant, V(V(2.0) * sqrt(t.inner)), V(V(bounds::orientation_2 * bounds::u) * (m * m)),
                           V(0.0), certified));
}

/// The filter stage of an empty circle, from the rounded differences b, p, q relative to a and e = q - p.
template <class V>
[[nodiscard]] Decision<V> decide_annulus(const Vector_2<V>& b, const Vector_2<V>& p, const Vector_2<V>& q,
                                         const Vector_2<V>& e, bool certified) {
    using std::max;
    using std::sqrt;
    const V m = max(V(max(magnitude(b), magnitude(p))), V(max(magnitude(q), magnitude(e))));
    const V m2 = m * m;
    const auto t = annulus_terms(b, p, q, e);
    return in_range(m, bounds::filter_range,
                    decide(t.determinant, V(sqrt(t.inner) + sqrt(t.outer)),
                           V(V(bounds::annulus_2_incircle * bounds::u) * (m2 * m2)),
                           V(V(bounds::annulus_2_norms * bounds::u) * (m2 * m)), certified));
}

}  // namespace detail

/// Filter stage of the orientation of a triangle (or of three consecutive hull vertices): positive when x[0], x[1],
/// x[2] turn left. Returns false when it cannot decide, or cannot give a tight tolerance; `out` is then unspecified.
///
/// The rounding mode must be to nearest. About 10 ns; batch.h is faster. Errors: bounds.h,
/// proofs/gappa/certificates_2.g.
[[nodiscard]] inline bool orientation_filter(const Tuple<2, 3>& x, bool certified, Certificate_value& out) {
    const auto d = detail::decide_orientation(detail::difference(x, 1, 0), detail::difference(x, 2, 0),
                                              detail::difference(x, 2, 1), certified);
    return detail::answer(d.sign, d.tolerance, out);
}

/// Filter stage of the empty circle of an edge: x = {a, b, p, q}, p right of ab, q left of it. Positive when the
/// circle through a, b, q leaves p strictly outside. Precondition: p is right of ab, q left of it; otherwise the sign
/// is that of the determinant. Returns false as orientation_filter does.
///
/// The rounding mode must be to nearest. About 15 ns; batch.h is faster. Errors: bounds.h,
/// proofs/gappa/certificates_2.g.
[[nodiscard]] inline bool empty_sphere_filter(const Tuple<2, 4>& x, bool certified, Certificate_value& out) {
    const auto d = detail::decide_annulus(detail::difference(x, 1, 0), detail::difference(x, 2, 0),
                                          detail::difference(x, 3, 0), detail::difference(x, 3, 2), certified);
    return detail::answer(d.sign, d.tolerance, out);
}

/// Interval stage. The rounding mode must be upward (one Rounding_guard around a batch). Returns false when the
/// interval of the determinant contains 0 or the tolerance is not within the stated slack. Never inlined: see
/// Rounding_guard.
[[nodiscard, gnu::noinline]] bool orientation_interval(const Tuple<2, 3>& x, Certificate_value& out);
[[nodiscard, gnu::noinline]] bool empty_sphere_interval(const Tuple<2, 4>& x, Certificate_value& out);

/// Exact stage: always answers, with the largest double not above the truth. Microseconds; where the sign is not
/// positive and integers of fixed width hold the points (integer_signs.h), a fraction of one.
[[nodiscard]] Certificate_value orientation_exact(const Tuple<2, 3>& x);
[[nodiscard]] Certificate_value empty_sphere_exact(const Tuple<2, 4>& x);

/// All stages for one certificate. The rounding mode must be to nearest, and is restored.
[[nodiscard]] Certificate_value evaluate_orientation(const Tuple<2, 3>& x, bool certified = true);
[[nodiscard]] Certificate_value evaluate_empty_sphere(const Tuple<2, 4>& x, bool certified = true);

/// Half the width of the paper's slab (its 2.2): half the altitude of x[2] over the line x[0] x[1], in plain double.
[[nodiscard]] inline double paper_slab(const Tuple<2, 3>& x) {
    const auto u = detail::difference(x, 1, 0);
    const auto v = detail::difference(x, 2, 0);
    return 0.5 * (u.x * v.y - u.y * v.x) / std::sqrt(u.x * u.x + u.y * u.y);
}

/// Half the width of the paper's slab of a hull vertex x[2] with neighbours x[0], x[1]: the same.
[[nodiscard]] inline double paper_ridge(const Tuple<2, 3>& x) { return paper_slab(x); }

}  // namespace annulus::inline v1
