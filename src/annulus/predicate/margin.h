// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/filtered.h>

#include <algorithm>
#include <array>

namespace annulus::inline v1 {

/// The largest difference of coordinates between the first point and another: the size of a certificate, in the unit
/// of the points. Plain double.
template <int d, std::size_t k>
[[nodiscard]] double extent(const std::array<const Coordinates<d>*, k>& x) {
    double m = 0;
    for (std::size_t i = 1; i < k; ++i) m = std::max(m, detail::magnitude(detail::difference(x, i, 0)));
    return m;
}

/// The ratio of the determinant that the filter stage computes to its error bound (bounds.h). Above 1 the sign is
/// certain; a tolerance as tight as promised needs 1 / filter_slack. Plain double, rounding to nearest; meaningless
/// where the size is out of the filter's range.
[[nodiscard]] inline double filter_margin(const Tuple<2, 3>& x) {
    using detail::difference;
    const auto u = difference(x, 1, 0), v = difference(x, 2, 0);
    const double m = extent<2>(x);
    return orientation_terms(u, v, difference(x, 2, 1)).determinant / (bounds::orientation_2 * bounds::u * (m * m));
}
[[nodiscard]] inline double filter_margin(const Tuple<2, 4>& x) {
    using detail::difference;
    const auto e = difference(x, 3, 2);
    const double m = std::max(extent<2>(x), detail::magnitude(e));
    const auto t = annulus_terms(difference(x, 1, 0), difference(x, 2, 0), difference(x, 3, 0), e);
    return t.determinant / (bounds::annulus_2_incircle * bounds::u * ((m * m) * (m * m)));
}
[[nodiscard]] inline double filter_margin(const Tuple<3, 4>& x) {
    using detail::difference;
    const double m = extent<3>(x);
    const auto t = orientation_terms(difference(x, 1, 0), difference(x, 2, 0), difference(x, 3, 0));
    return t.determinant / (bounds::orientation_3 * bounds::u * (m * m * m));
}
[[nodiscard]] inline double filter_margin(const Tuple<3, 5>& x) {
    using detail::difference;
    const double m = extent<3>(x);
    const auto t = annulus_terms(difference(x, 1, 0), difference(x, 2, 0), difference(x, 3, 0), difference(x, 4, 0));
    return t.determinant / (bounds::annulus_3_insphere * bounds::u * ((m * m) * (m * m) * m));
}

}  // namespace annulus::inline v1
