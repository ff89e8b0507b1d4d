// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <limits>

namespace annulus {

/// A reading of an odometer at which a certificate expires, rounded down: the upper half of a double, so that a step has
/// half as much to fetch. It has the range of a double and 21 significant bits, and an expiry too low by 2^-20 of the
/// reading costs an evaluation now and then, never an answer. Non-negative.
class Expiry {
  public:
    constexpr Expiry() = default;  // 0
    /// The largest not above `reading`; 0 unless that is positive.
    [[nodiscard]] static constexpr Expiry lower(double reading) {
        // The bits of a positive double grow with it, and dropping the lower ones is rounding towards 0.
        return Expiry(reading > 0.0 ? static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(reading) >> 32) : 0U);
    }
    [[nodiscard]] static constexpr Expiry never() { return lower(std::numeric_limits<double>::infinity()); }
    [[nodiscard]] constexpr double reading() const {
        return std::bit_cast<double>(static_cast<std::uint64_t>(upper_half_) << 32);
    }
    friend constexpr auto operator<=>(const Expiry&, const Expiry&) = default;

  private:
    constexpr explicit Expiry(std::uint32_t upper_half) : upper_half_(upper_half) {}
    std::uint32_t upper_half_ = 0;
};

}  // namespace annulus
