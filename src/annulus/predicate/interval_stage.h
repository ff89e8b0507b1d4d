// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/interval.h>
#include <annulus/predicate/bounds.h>
#include <annulus/predicate/certificate_value.h>

#include <algorithm>
#include <array>
#include <cmath>

// What the interval stages of both dimensions share. All of it assumes upward rounding: see Rounding_guard.
namespace annulus::inline v1::detail {

/// A scale as two factors. One power of two can itself leave the range of doubles (differences of 2^-1074 need
/// 2^1073).
struct Scale {
    double first = 1.0;
    double second = 1.0;
};

/// Differences between 2^-100 and 2^100 in magnitude are not scaled: no product leaves the range of doubles, and
/// underflow is enclosed like any other rounding.
inline constexpr double unscaled_range = 0x1p100;

/// The largest magnitude of a coordinate's difference to the first point, rounded up.
template <std::size_t d, std::size_t k>
[[nodiscard]] double largest_difference(const std::array<const std::array<double, d>*, k>& x) {
    double m = 0.0;
    for (std::size_t i = 1; i < k; ++i)
        for (const double c : annulus::difference(x, i, 0)) m = std::max(m, std::fabs(c));
    return m;
}

/// Calls evaluate(difference, scale), where difference(a, b) is the interval of the difference of two coordinates. It
/// is scaled so that differences to the first point are at most 1, unless they are in the unscaled range.
template <std::size_t d, std::size_t k, class Evaluate>
[[nodiscard]] bool with_scale(const std::array<const std::array<double, d>*, k>& x, Evaluate evaluate) {
    const double m = largest_difference(x);
    if (m <= unscaled_range && m * unscaled_range >= 1.0)
        return evaluate([](double a, double b) { return Interval(a) - Interval(b); }, Scale{});
    const int exponent = m > 0.0 ? -std::ilogb(m) - 1 : 0;
    const int half = exponent / 2;
    const Scale s{std::scalbn(1.0, half), std::scalbn(1.0, exponent - half)};
    const auto difference = [&s](double a, double b) { return scaled_difference(a, b, s.first) * Interval(s.second); };
    return evaluate(difference, s);
}

/// sqrt(x) + sqrt(y), an upper bound. The square roots are rounded upward like everything else: Boost.Interval's own
/// root would switch the rounding mode for the lower end, which costs more than all the rest.
[[nodiscard]] inline double roots_upper(const Interval& x, const Interval& y) {
    return std::sqrt(x.upper()) + std::sqrt(y.upper());
}
/// At most a few units in the last place above the lower bound. Used only to test tightness, where that does no harm.
[[nodiscard]] inline double roots_about(const Interval& x, const Interval& y) {
    return std::sqrt(x.lower()) + std::sqrt(y.lower());
}

/// x / y, a lower bound: -x / y, rounded upward, is at least -(x / y). Preconditions: x >= 0, y > 0, upward rounding.
[[nodiscard]] inline double quotient_lower(double x, double y) { return -(-x / y); }

/// Whether the ends of a positive number are as near to one another as the interval stage promises. The allowed
/// difference is rounded downward, which matters where it is subnormal.
[[nodiscard]] inline bool within_slack(double lower, double upper) {
    return upper - lower <= -(-bounds::interval_slack * lower);
}

/// The tolerance determinant / roots, still scaled. Returns false when it is not within the stated slack.
/// Precondition: determinant > 0.
[[nodiscard]] inline bool quotient_lower_in_slack(const Interval& determinant, double roots_most, double roots_least,
                                                  double& lower) {
    lower = quotient_lower(determinant.lower(), roots_most);
    return within_slack(lower, determinant.upper() / roots_least);
}

/// Undoes the scale: exact unless the result is subnormal; then the quotient is still a lower bound.
[[nodiscard]] inline double unscaled_lower(double x, const Scale& s) {
    return quotient_lower(quotient_lower(x, s.first), s.second);
}

/// Stores the sign, before any tolerance. Returns false when the interval contains 0.
[[nodiscard]] inline bool interval_sign(const Interval& determinant, Certificate_value& out) {
    out.stage = Stage::interval;
    out.tolerance = 0.0;
    out.sign = static_cast<std::int8_t>(determinant.lower() > 0.0 ? 1 : determinant.upper() < 0.0 ? -1 : 0);
    return out.sign != 0;
}

}  // namespace annulus::inline v1::detail
