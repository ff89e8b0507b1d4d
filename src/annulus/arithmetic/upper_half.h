// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/horizons.h>

#include <bit>
#include <compare>
#include <cstdint>
#include <limits>

namespace annulus {

/// The upper half of a double, for what is kept of every vertex or certificate and read at every step: half as much to
/// fetch. It has the range of a double and 21 significant bits; making one rounds towards 0.
class Upper_half {
  public:
    constexpr Upper_half() = default;  // 0
    /// That of the same sign and the largest magnitude not above |x|. x is no NaN.
    [[nodiscard]] static constexpr Upper_half truncated(double x) {
        return Upper_half(static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> 32) & Horizons::half_mask);
    }
    /// The largest not above x, but 0 when x is not positive (or is no number).
    [[nodiscard]] static constexpr Upper_half lower(double x) { return x > 0.0 ? truncated(x) : Upper_half(); }
    [[nodiscard]] static constexpr Upper_half infinity() { return truncated(std::numeric_limits<double>::infinity()); }
    /// What bits() gave.
    [[nodiscard]] static constexpr Upper_half of_bits(std::uint32_t bits) { return Upper_half(bits); }

    [[nodiscard]] constexpr double value() const {
        return std::bit_cast<double>(static_cast<std::uint64_t>(bits_) << 32);
    }
    /// Grows with the value when that is not negative.
    [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
    friend constexpr bool operator==(const Upper_half&, const Upper_half&) = default;

  private:
    constexpr explicit Upper_half(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_ = 0;
};

}  // namespace annulus
