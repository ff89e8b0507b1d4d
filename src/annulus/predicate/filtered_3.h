// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/certificate_value.h>
#include <annulus/predicate/decide.h>
#include <annulus/predicate/width_terms_3.h>

#include <algorithm>
#include <cmath>

// The filtered predicate in 3D. Orientations are CGAL's: a, b, c, d is positive when d is on the side of (b - a) x (c
// - a). A bi-cell is x = {a, b, c, p, q} with positive cells a b c q and b a c p. So the facet a b c turns left as
// seen from q, and p is behind it. In 2D it is {a, b, p, q} with positive triangles a b q and b a p.

namespace annulus::inline v1 {

/// Whether the widths of the two cells enter the tolerance of an empty sphere in 3D (docs/theory.md 2.2, remark).
///
/// If A is on the inner side of the annulus of a partition A | B (the sum of lambda over B is positive), the annulus
/// excludes the partition wherever its points are. Otherwise the partition is on the wrong side: the annulus excludes
/// it only along a motion on which both cells stay positive, from the same reference.
enum class Cell_widths : std::uint8_t {
    never,  ///< the least of the four annuli; see Certificate_value::wrong_side
    /// With the cells where one of the sums is not positive: safe by itself. If a stage cannot decide whether a sum is,
    /// and the tolerance depends on it, it leaves the answer to the next stage: the answer is the same for any order of
    /// the points.
    where_needed,
    always,  ///< the sign tolerance of theory 2: for use where only a motion is known of the cells
};

namespace detail {

/// The filter stage of a tetrahedron, from the terms of its orientation and the largest difference m.
template <class V>
[[nodiscard]] Decision<V> decide_width(const Width_terms<V>& t, const V& m, bool certified) {
    using std::sqrt;
    const V m2 = m * m;
    return decide(t.determinant, V(V(2.0) * sqrt(t.inner)), V(V(bounds::orientation_3 * bounds::u) * (m2 * m)),
                  V(V(bounds::orientation_3_norms * bounds::u) * m2), certified);
}

/// The filter stage of an orientation, from the rounded differences to the first point.
template <class V>
[[nodiscard]] Decision<V> decide_orientation(const Vector_3<V>& u, const Vector_3<V>& v, const Vector_3<V>& w,
                                             bool certified) {
    using std::max;
    const V m = max(V(max(magnitude(u), magnitude(v))), magnitude(w));
    return in_range(m, bounds::filter_range_3, decide_width(orientation_terms(u, v, w), m, certified));
}

/// The four sums of norms of a bi-cell.
template <class V>
[[nodiscard]] std::array<V, partitions_3> norms(const Bicell_terms_3<V>& t) {
    using std::sqrt;
    std::array<V, partitions_3> sum;
    for (std::size_t k = 0; k < partitions_3; ++k) sum[k] = sqrt(t.inner[k]) + sqrt(t.outer[k]);
    return sum;
}

/// A Decision, and the partitions on the wrong side: bit k as the number 2^k.
template <class V>
struct Bicell_decision {
    Decision<V> decision;
    V wrong_side;
};

/// The filter stage of an empty sphere, from the rounded differences to a.
template <class V>
[[nodiscard]] Bicell_decision<V> decide_annulus(const Vector_3<V>& b, const Vector_3<V>& c, const Vector_3<V>& p,
                                                const Vector_3<V>& q, bool certified, Cell_widths cells) {
    using std::max;
    using std::min;
    const V m = max(V(max(magnitude(b), magnitude(c))), V(max(magnitude(p), magnitude(q))));
    const V m2 = m * m;
    const auto t = annulus_terms(b, c, p, q);
    const auto sum = norms(t);
    const V largest = max(V(max(sum[0], sum[1])), V(max(sum[2], sum[3])));
    Decision<V> d = decide(t.determinant, largest, V(V(bounds::annulus_3_insphere * bounds::u) * (m2 * m2 * m)),
                           V(V(bounds::annulus_3_norms * bounds::u) * (m2 * m2)), certified);
    const V side_error = V(bounds::annulus_3_side * bounds::u) * (m2 * m);
    V wrong_side(0.0);
    for (std::size_t k = 1; k < partitions_3; ++k)
        wrong_side = wrong_side + select(t.side[k] > side_error, V(0.0), V(static_cast<double>(1U << k)));
    if (cells != Cell_widths::never) {
        const auto needed = cells == Cell_widths::always ? wrong_side >= V(0.0) : wrong_side > V(0.0);
        if (any(needed)) {  // the only branch: the widths are half of the work, and often they are not needed
            const V annuli = d.tolerance;
            d = both(d, decide_width(cell_p_terms(t), m, certified), needed);
            d = both(d, decide_width(cell_q_terms(t), m, certified), needed);
            if (certified && cells == Cell_widths::where_needed) {
                const V least = min(V(min(t.side[1], t.side[2])), t.side[3]);
                d = unless(d, !(least < -side_error) && d.tolerance < annuli);
            }
        }
    }
    return {in_range(m, bounds::filter_range_3, d), wrong_side};
}

[[nodiscard]] inline bool answer(const Bicell_decision<double>& d, Certificate_value& out) {
    out.wrong_side = static_cast<std::uint8_t>(d.wrong_side);
    return answer(d.decision.sign, d.decision.tolerance, out);
}

}  // namespace detail

/// Filter stage of the orientation of a tetrahedron (a cell, or a hull ridge): positive in CGAL's sense. The tolerance
/// is half its width. Returns false when it cannot decide, or cannot give a tight tolerance; `out` is then
/// unspecified.
///
/// The rounding mode must be to nearest. Errors: bounds.h, proofs/gappa/certificates_3.g.
[[nodiscard]] inline bool orientation_filter(const Tuple<3, 4>& x, bool certified, Certificate_value& out) {
    const auto d = detail::decide_orientation(detail::difference(x, 1, 0), detail::difference(x, 2, 0),
                                              detail::difference(x, 3, 0), certified);
    return detail::answer(d.sign, d.tolerance, out);
}

/// Filter stage of the empty sphere of the facet a b c, x = {a, b, c, p, q}: positive when the sphere through a, b, c,
/// p leaves q strictly outside. The tolerance is the least half width of the four annuli, and of the cells as `cells`
/// says. Returns false as orientation_filter does. Precondition: both cells are positive. Where one is not, the sign
/// is right, and no tolerance is given that depends on it by `cells`.
///
/// The rounding mode must be to nearest. Errors: bounds.h, proofs/gappa/certificates_3.g.
[[nodiscard]] inline bool empty_sphere_filter(const Tuple<3, 5>& x, bool certified, Certificate_value& out,
                                              Cell_widths cells = Cell_widths::where_needed) {
    return detail::answer(
        detail::decide_annulus(detail::difference(x, 1, 0), detail::difference(x, 2, 0), detail::difference(x, 3, 0),
                               detail::difference(x, 4, 0), certified, cells),
        out);
}

/// Interval stage. The rounding mode must be upward (one Rounding_guard around a batch). Returns false when the
/// interval of the determinant contains 0 or the tolerance is not within the stated slack. Never inlined: see
/// Rounding_guard.
[[nodiscard, gnu::noinline]] bool orientation_interval(const Tuple<3, 4>& x, Certificate_value& out);
[[nodiscard, gnu::noinline]] bool empty_sphere_interval(const Tuple<3, 5>& x, Certificate_value& out,
                                                        Cell_widths cells = Cell_widths::where_needed);

/// Exact stage: always answers, with the largest double not above the truth. Microseconds; where the sign is not
/// positive and integers of fixed width hold the points (integer_signs.h), a fraction of one.
[[nodiscard]] Certificate_value orientation_exact(const Tuple<3, 4>& x);
[[nodiscard]] Certificate_value empty_sphere_exact(const Tuple<3, 5>& x, Cell_widths cells = Cell_widths::where_needed);

/// All stages for one certificate. The rounding mode must be to nearest, and is restored.
[[nodiscard]] Certificate_value evaluate_orientation(const Tuple<3, 4>& x, bool certified = true);
[[nodiscard]] Certificate_value evaluate_empty_sphere(const Tuple<3, 5>& x, bool certified = true,
                                                      Cell_widths cells = Cell_widths::where_needed);

/// The four annuli of a bi-cell, each separately, in the order of Partition_3.
struct Annuli {
    std::array<double, partitions_3> half_width{};  ///< the largest double not above |P| / (sum of norms)
    std::array<std::int8_t, partitions_3> side{};   ///< exact sign of the sum of lambda over B
    std::int8_t sign = 0;                           ///< exact sign of the empty sphere
};
/// Exact. The first one is the paper's standard annulus. For analysis, not for speed.
[[nodiscard]] Annuli annuli_exact(const Tuple<3, 5>& x);

/// Half the width of the paper's standard annulus, abc | pq, in plain double; 0 where the sphere is not empty.
[[nodiscard]] inline double paper_annulus(const Tuple<3, 5>& x) {
    const auto t = annulus_terms(detail::difference(x, 1, 0), detail::difference(x, 2, 0), detail::difference(x, 3, 0),
                                 detail::difference(x, 4, 0));
    return std::max(0.0, t.determinant / (std::sqrt(t.inner[abc_pq]) + std::sqrt(t.outer[abc_pq])));
}

/// Half the width of the paper's slab (its 2.2): half the altitude of x[3] over the plane of x[0], x[1], x[2], in
/// plain double.
[[nodiscard]] inline double paper_slab(const Tuple<3, 4>& x) {
    const auto n = cross(detail::difference(x, 1, 0), detail::difference(x, 2, 0));
    return 0.5 * dot(n, detail::difference(x, 3, 0)) / std::sqrt(square(n));
}

/// Half the width of the paper's slab of a hull ridge x[0] x[1], in plain double: that between the planes parallel to
/// it and to x[2] x[3].
[[nodiscard]] inline double paper_ridge(const Tuple<3, 4>& x) {
    const auto n = cross(detail::difference(x, 1, 0), detail::difference(x, 3, 2));
    return 0.5 * std::fabs(dot(n, detail::difference(x, 2, 0))) / std::sqrt(square(n));
}

}  // namespace annulus::inline v1
