// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/certificate_value.h>
#include <annulus/predicate/decide.h>
#include <annulus/predicate/width_terms_3.h>

#include <algorithm>

namespace annulus::inline v1 {

// The sign of an orientation and nothing else, by the filter stage: 0 where the next stage has to decide. The
// determinants and errors are those of Circumcircle_2 and Circumsphere_3 (bounds.h). The rounding mode must be to
// nearest.

namespace detail {

[[nodiscard]] inline int clear_sign(double determinant, double error, double magnitude, double range) {
    if (!(magnitude <= range && magnitude * range >= 1.0)) return 0;
    return determinant > error ? 1 : determinant < -error ? -1 : 0;
}

}  // namespace detail

[[nodiscard]] inline int orientation_sign(const Tuple<2, 3>& x) {
    const auto u = detail::difference(x, 1, 0), v = detail::difference(x, 2, 0);
    const double m = std::max(detail::magnitude(u), detail::magnitude(v));
    return detail::clear_sign(u.x * v.y - u.y * v.x, bounds::orientation_2 * bounds::u * (m * m), m,
                              bounds::filter_range);
}

[[nodiscard]] inline int orientation_sign(const Tuple<3, 4>& x) {
    const auto u = detail::difference(x, 1, 0), v = detail::difference(x, 2, 0), w = detail::difference(x, 3, 0);
    const double m = std::max(detail::magnitude(u), std::max(detail::magnitude(v), detail::magnitude(w)));
    return detail::clear_sign(dot(cross(u, v), w), bounds::orientation_3 * bounds::u * (m * m * m), m,
                              bounds::filter_range_3);
}

}  // namespace annulus::inline v1
