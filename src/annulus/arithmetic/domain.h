// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

/// The error of points that are not in the domain: `whose` is "point", "vertex" or "row", `refused` their numbers in
/// ascending order, x the first of them.
template <std::size_t d>
[[nodiscard]] inline Error domain_error(const std::array<double, d>& x, const char* whose,
                                        std::vector<std::int64_t> refused) {
    bool finite = true;
    for (const double c : x) finite = finite && is_finite_number(c);
    std::string what = "a coordinate of " + std::string(whose) + " " + std::to_string(refused.front()) +
                       (finite ? " is larger than 2^500 in magnitude" : " is not a finite number");
    if (refused.size() > 1) what += ", as are coordinates of " + std::to_string(refused.size() - 1) + " more";
    return {finite ? Error_code::out_of_domain : Error_code::not_finite, what, std::move(refused)};
}

/// The same for a point with a number.
template <std::size_t d>
inline void require_in_domain(const std::array<double, d>& x, const char* whose, std::int64_t i) {
    if (!in_domain(x)) throw Error(domain_error(x, whose, {i}));
}

/// Throws domain_error with the numbers of all x[k] that are not in the domain; number(k) is that of x[k], or `none` if
/// x[k] does not count. O(n).
template <std::size_t d, class Number>
inline void require_in_domain(std::span<const std::array<double, d>> x, const char* whose, Number number) {
    std::vector<std::int64_t> refused;
    std::size_t least = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        if (in_domain(x[k]) || number(k) == none) continue;
        if (refused.empty() || number(k) < number(least)) least = k;
        refused.push_back(static_cast<std::int64_t>(number(k)));
    }
    if (refused.empty()) return;
    std::sort(refused.begin(), refused.end());
    refused.erase(std::unique(refused.begin(), refused.end()), refused.end());
    throw Error(domain_error(x[least], whose, std::move(refused)));
}
template <std::size_t d>
inline void require_in_domain(std::span<const std::array<double, d>> x, const char* whose) {
    require_in_domain(x, whose, [](std::size_t k) { return static_cast<std::int64_t>(k); });
}

}  // namespace annulus::inline v1
