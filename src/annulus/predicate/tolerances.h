// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/filtered_2.h>
#include <annulus/predicate/filtered_3.h>

#include <algorithm>
#include <span>

// Tolerances that are the least of several half widths.
namespace annulus::inline v1 {

/// One certificate, with the given precision of its tolerance.
template <class T>
[[nodiscard]] Certificate_value evaluate_orientation(const T& x, Tolerance_precision mode) {
    const Certificate_value v = evaluate_orientation(x, mode != Tolerance_precision::approximate);
    return mode == Tolerance_precision::correctly_rounded && v.sign > 0 ? orientation_exact(x) : v;
}
template <class T>
[[nodiscard]] Certificate_value evaluate_empty_sphere(const T& x, Tolerance_precision mode) {
    const Certificate_value v = evaluate_empty_sphere(x, mode != Tolerance_precision::approximate);
    return mode == Tolerance_precision::correctly_rounded && v.sign > 0 ? empty_sphere_exact(x) : v;
}

/// The sign tolerance of a bi-cell: the least half width of its annuli and its two cells. As long as every point is
/// closer than that to its position here, the sign of the empty sphere does not change (theory 2). Precondition: both
/// cells are positive; where one is not the tolerance is 0. The stage is the last one that was needed.
[[nodiscard]] inline Certificate_value evaluate_sign_tolerance(
    const Tuple<2, 4>& x, Tolerance_precision mode = Tolerance_precision::lower_bound) {
    Certificate_value out = evaluate_empty_sphere(x, mode);
    if (out.sign <= 0) return out;
    for (const Tuple<2, 3>& cell : {Tuple<2, 3>{x[1], x[0], x[2]}, Tuple<2, 3>{x[0], x[1], x[3]}}) {
        const Certificate_value v = evaluate_orientation(cell, mode);
        out.tolerance = std::min(out.tolerance, v.tolerance);
        out.stage = std::max(out.stage, v.stage);
    }
    return out;
}
[[nodiscard]] inline Certificate_value evaluate_sign_tolerance(
    const Tuple<3, 5>& x, Tolerance_precision mode = Tolerance_precision::lower_bound) {
    const Certificate_value v = evaluate_empty_sphere(x, mode != Tolerance_precision::approximate, Cell_widths::always);
    return mode == Tolerance_precision::correctly_rounded && v.sign > 0 ? empty_sphere_exact(x, Cell_widths::always)
                                                                        : v;
}

/// Lowers the tolerance of every vertex of certificate i to that of value i. Start with `tolerance` infinite and make
/// one call for each kind of certificate: the result is the vertex tolerance, the least over the certificates that
/// contain the vertex.
template <std::size_t k>
void lower_to_certificates(std::span<const std::array<Index, k>> points, std::span<const Certificate_value> values,
                           std::span<double> tolerance) {
    for (std::size_t i = 0; i < points.size(); ++i)
        for (const Index v : points[i]) {
            double& t = tolerance[static_cast<std::size_t>(v)];
            t = std::min(t, values[i].tolerance);
        }
}

}  // namespace annulus::inline v1
