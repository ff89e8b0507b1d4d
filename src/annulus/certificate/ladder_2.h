// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/certificate/bounds.h>
#include <annulus/certificate/verdict.h>
#include <annulus/certificate/width_terms.h>

#include <algorithm>
#include <cmath>

namespace annulus {

namespace detail {

[[nodiscard]] inline Vector_2<double> difference(const Coordinates<2>& a, const Coordinates<2>& b) {
    return {a[0] - b[0], a[1] - b[1]};
}
[[nodiscard]] inline double magnitude(const Vector_2<double>& v) { return std::max(std::fabs(v.x), std::fabs(v.y)); }

/// Accepts the rounded terms of a certificate when the error bounds leave the sign certain and the tolerance tight.
///
/// `det_error` bounds |determinant~ - determinant| and `norm_error` what the computed roots may be short by, both
/// absolute. With certified = false the tolerance is the plain quotient and only the sign is decided here.
[[nodiscard]] inline bool accept(const Width_terms<double>& t, double det_error, double norm_error, bool certified,
                                 Verdict& out) {
    out.stage = Stage::filter;
    if (t.determinant < -det_error) {
        out.sign = -1;
        out.tolerance = 0.0;
        return true;
    }
    if (!(t.determinant * bounds::filter_slack > det_error)) return false;
    out.sign = 1;
    const double roots = std::sqrt(t.inner) + std::sqrt(t.outer);
    if (!certified) {
        out.tolerance = t.determinant / roots;
        return true;
    }
    if (!(roots * bounds::filter_slack > norm_error)) return false;
    out.tolerance = (t.determinant - det_error) / (roots + norm_error) * (1.0 - bounds::tail * bounds::u);
    return true;
}

}  // namespace detail

/// Filter stage of the orientation of a triangle (or of three consecutive hull vertices): positive when x[0], x[1],
/// x[2] turn left. False when it cannot tell or cannot tell tightly; `out` is then unspecified.
///
/// Rounding mode must be to nearest. About 15 ns. Errors: bounds.h, proofs/gappa/certificates_2.g.
[[nodiscard]] inline bool orientation_filter(const Tuple<2, 3>& x, bool certified, Verdict& out) {
    const auto u = detail::difference(*x[1], *x[0]);
    const auto v = detail::difference(*x[2], *x[0]);
    const auto w = detail::difference(*x[2], *x[1]);
    const double m = std::max(detail::magnitude(u), detail::magnitude(v));
    if (!(m <= bounds::filter_range && m * bounds::filter_range >= 1.0)) return false;
    // The sides are relative to u each, so the norms carry relative errors only: no absolute norm error.
    return detail::accept(orientation_terms(u, v, w), bounds::orientation_2 * bounds::u * (m * m), 0.0, certified, out);
}

/// Filter stage of the empty circle of an edge: x = {a, b, p, q}, p right of ab, q left of it. Positive when the
/// circle through a, b, q leaves p strictly outside. False as for orientation_filter.
///
/// Rounding mode must be to nearest. About 20 ns. Errors: bounds.h, proofs/gappa/certificates_2.g.
[[nodiscard]] inline bool empty_sphere_filter(const Tuple<2, 4>& x, bool certified, Verdict& out) {
    const auto b = detail::difference(*x[1], *x[0]);
    const auto p = detail::difference(*x[2], *x[0]);
    const auto q = detail::difference(*x[3], *x[0]);
    const auto e = detail::difference(*x[3], *x[2]);
    const double m = std::max(std::max(detail::magnitude(b), detail::magnitude(p)),
                              std::max(detail::magnitude(q), detail::magnitude(e)));
    if (!(m <= bounds::filter_range && m * bounds::filter_range >= 1.0)) return false;
    const double m2 = m * m;
    const double m3 = m2 * m;
    return detail::accept(annulus_terms(b, p, q, e), bounds::annulus_2_incircle * bounds::u * (m2 * m2),
                          bounds::annulus_2_norms * bounds::u * m3, certified, out);
}

/// Interval stage. The rounding mode must be upward (one Rounding_guard around a batch). False when the interval of
/// the determinant holds 0 or the tolerance is not within the stated slack.
/// Never inlined: see Rounding_guard.
[[nodiscard, gnu::noinline]] bool orientation_interval(const Tuple<2, 3>& x, Verdict& out);
[[nodiscard, gnu::noinline]] bool empty_sphere_interval(const Tuple<2, 4>& x, Verdict& out);

/// Exact stage: always answers. Microseconds.
[[nodiscard]] Verdict orientation_exact(const Tuple<2, 3>& x);
[[nodiscard]] Verdict empty_sphere_exact(const Tuple<2, 4>& x);

/// The whole ladder for one certificate; the rounding mode must be to nearest and is put back.
[[nodiscard]] Verdict orientation_verdict(const Tuple<2, 3>& x, bool certified = true);
[[nodiscard]] Verdict empty_sphere_verdict(const Tuple<2, 4>& x, bool certified = true);

/// Half the width of the paper's slab (its 2.2): the altitude of x[2] over the line x[0] x[1], in plain double.
[[nodiscard]] inline double paper_slab(const Tuple<2, 3>& x) {
    const auto u = detail::difference(*x[1], *x[0]);
    const auto v = detail::difference(*x[2], *x[0]);
    return 0.5 * (u.x * v.y - u.y * v.x) / std::sqrt(u.x * u.x + u.y * u.y);
}

/// Sign of the empty circle of x = {a, b, p, q} with CGAL's lexicographic symbolic perturbation where the four points
/// are cocircular: never 0. Precondition: empty_sphere_verdict(x).sign == 0 and both triangles are positive.
///
/// CGAL's removal relies on the triangulation being the one this perturbation picks (theory 6), so that flips decide
/// cocircular cases with it. Devillers and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D
/// triangulations, 2011.
[[nodiscard]] int perturbed_empty_circle_sign(const Tuple<2, 4>& x);

}  // namespace annulus
