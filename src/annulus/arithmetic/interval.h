// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/environment.h>

#include <boost/numeric/interval.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>

namespace annulus::inline v1 {

/// The one Boost.Interval policy of the library: every operation assumes that the rounding mode is already upward.
///
/// Computing with an Interval outside the scope of a `Rounding_guard(FE_UPWARD)` gives bounds that are not bounds.
/// Boost's default policy switches the mode in every operation and is twenty times slower.
using Interval = boost::numeric::interval<
    double, boost::numeric::interval_lib::policies<boost::numeric::interval_lib::save_state_nothing<
                                                       boost::numeric::interval_lib::rounded_transc_opp<double>>,
                                                   boost::numeric::interval_lib::checking_base<double>>>;

/// The interval that holds a - b, for doubles, scaled by `scale`, a power of two.
[[nodiscard]] inline Interval scaled_difference(double a, double b, double scale) {
    return (Interval(a) - Interval(b)) * Interval(scale);
}

/// x^2 as an interval that is never negative (x*x treats its factors as independent).
[[nodiscard]] inline Interval squared(const Interval& x) { return boost::numeric::square(x); }

/// The same for every other number type.
template <class T>
concept Multipliable = std::convertible_to<decltype(std::declval<const T&>() * std::declval<const T&>()), T>;
template <Multipliable T>
[[nodiscard]] T squared(const T& x) {
    return x * x;
}

}  // namespace annulus::inline v1
