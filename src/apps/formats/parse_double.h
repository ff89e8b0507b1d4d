// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace annulus::inline v1 {

/// The result of reading a decimal number.
enum class Number_kind { finite, not_a_number, nan, too_large };

/// Decimal to double, correctly rounded (to nearest) and independent of the locale; a leading + is accepted, further
/// characters after the number are not. Fortran's exponents are accepted in numbers of up to 64 characters: 1.5D+01,
/// 1.5d1, and with a point, a sign and three digits 1.5-101. Magnitudes too small for a double give zero, infinities
/// and those too large are `too_large`.
[[nodiscard]] Number_kind parse_double(std::string_view text, double& value) noexcept;

}  // namespace annulus::inline v1
