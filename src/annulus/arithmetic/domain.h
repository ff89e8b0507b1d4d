// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

#include <bit>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

/// The coordinate domain: every finite double of magnitude at most 2^500, subnormals and zeros included.
///
/// The bound keeps squared distances finite (a difference is at most 2^501, a sum of three squares below 2^1004), so
/// the comparison of a displacement with a tolerance never overflows. Determinants of higher degree are evaluated on
/// differences scaled by a power of two, so they neither overflow nor underflow at either end of the domain.
inline constexpr double coordinate_limit = 0x1p500;

/// The bits of x without its sign: the order of magnitudes, with infinity and every NaN above all numbers.
[[nodiscard]] constexpr std::uint64_t magnitude_bits(double x) noexcept { return std::bit_cast<std::uint64_t>(x) << 1; }

/// True when x is a number inside the coordinate domain (false for NaN and infinities). Compares bits, so that no
/// flag of a caller's compiler can take a NaN for a number.
[[nodiscard]] constexpr bool in_domain(double x) noexcept {
    return magnitude_bits(x) <= magnitude_bits(coordinate_limit);
}
[[nodiscard]] constexpr bool is_finite_number(double x) noexcept {
    return magnitude_bits(x) < magnitude_bits(std::numeric_limits<double>::infinity());
}

template <std::size_t d>
[[nodiscard]] inline bool in_domain(const std::array<double, d>& x) noexcept {
    for (const double c : x)
        if (!in_domain(c)) return false;
    return true;
}

/// Throws Error(not_finite) or Error(out_of_domain) unless x is in the domain.
template <std::size_t d>
inline void require_in_domain(const std::array<double, d>& x) {
    if (in_domain(x)) return;
    for (const double c : x)
        if (!is_finite_number(c)) throw Error(Error_code::not_finite, "a coordinate is not a finite number");
    throw Error(Error_code::out_of_domain, "a coordinate is larger than 2^500 in magnitude");
}

/// The same, with a message that names the point: `whose` is "point" or "vertex", i its index.
template <std::size_t d>
inline void require_in_domain(const std::array<double, d>& x, const char* whose, std::int64_t i) {
    if (in_domain(x)) return;
    const std::string of = "a coordinate of " + std::string(whose) + " " + std::to_string(i);
    for (const double c : x)
        if (!is_finite_number(c)) throw Error(Error_code::not_finite, of + " is not a finite number", {i});
    throw Error(Error_code::out_of_domain, of + " is larger than 2^500 in magnitude", {i});
}

}  // namespace annulus::inline v1
