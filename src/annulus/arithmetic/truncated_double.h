// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/limits.h>

#include <bit>
#include <compare>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

/// The upper half of a double, for values that are stored for every vertex or certificate and read at every step: half
/// the memory traffic. It has the range of a double and 21 significant bits; construction rounds towards 0.
class Truncated_double {
  public:
    constexpr Truncated_double() = default;  // 0
    /// The value with the sign of x and the largest magnitude not above |x|. Precondition: x is not a NaN.
    [[nodiscard]] static constexpr Truncated_double truncated(double x) {
        return Truncated_double(static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> 32) & Limits::half_mask);
    }
    /// The largest value not above x, or 0 when x is not positive (or a NaN).
    [[nodiscard]] static constexpr Truncated_double lower(double x) {
        return x > 0.0 ? truncated(x) : Truncated_double();
    }
    [[nodiscard]] static constexpr Truncated_double infinity() {
        return truncated(std::numeric_limits<double>::infinity());
    }
    /// The inverse of bits().
    [[nodiscard]] static constexpr Truncated_double of_bits(std::uint32_t bits) { return Truncated_double(bits); }

    [[nodiscard]] constexpr double value() const {
        return std::bit_cast<double>(static_cast<std::uint64_t>(bits_) << 32);
    }
    /// Increases with the value when that is not negative.
    [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
    friend constexpr bool operator==(const Truncated_double&, const Truncated_double&) = default;

  private:
    constexpr explicit Truncated_double(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_ = 0;
};

}  // namespace annulus::inline v1
