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
class High_word {
  public:
    constexpr High_word() = default;  // 0
    /// That of the same sign and the largest magnitude not above |x|. x is no NaN.
    [[nodiscard]] static constexpr High_word truncated(double x) {
        return High_word(static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> 32) & Horizons::half_mask);
    }
    /// The largest not above x, but 0 when x is not positive (or is no number).
    [[nodiscard]] static constexpr High_word lower(double x) { return x > 0.0 ? truncated(x) : High_word(); }
    [[nodiscard]] static constexpr High_word infinity() { return truncated(std::numeric_limits<double>::infinity()); }
    /// What bits() gave.
    [[nodiscard]] static constexpr High_word of_bits(std::uint32_t bits) { return High_word(bits); }

    [[nodiscard]] constexpr double value() const {
        return std::bit_cast<double>(static_cast<std::uint64_t>(bits_) << 32);
    }
    /// Grows with the value when that is not negative.
    [[nodiscard]] constexpr std::uint32_t bits() const { return bits_; }
    friend constexpr bool operator==(const High_word&, const High_word&) = default;

  private:
    constexpr explicit High_word(std::uint32_t bits) : bits_(bits) {}
    std::uint32_t bits_ = 0;
};

}  // namespace annulus
