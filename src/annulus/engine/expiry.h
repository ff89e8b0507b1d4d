// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/truncated_double.h>

#include <compare>
#include <cstdint>

namespace annulus {

/// A reading of an odometer at which a certificate expires, rounded down: too low by 2^-20 of the reading at most,
/// which costs an evaluation now and then, never an answer. Non-negative.
class Expiry {
  public:
    constexpr Expiry() = default;  // 0
    /// The largest not above `reading`; 0 unless that is positive.
    [[nodiscard]] static constexpr Expiry lower(double reading) { return Expiry(Truncated_double::lower(reading)); }
    [[nodiscard]] static constexpr Expiry never() { return Expiry(Truncated_double::infinity()); }
    /// What bits() gave.
    [[nodiscard]] static constexpr Expiry of_bits(std::uint32_t bits) {
        return Expiry(Truncated_double::of_bits(bits));
    }

    [[nodiscard]] constexpr double reading() const { return half_.value(); }
    [[nodiscard]] constexpr std::uint32_t bits() const { return half_.bits(); }
    /// reading >= this->reading(): as this one's lower half is 0, the upper halves tell. Precondition: reading >= 0.
    [[nodiscard]] constexpr bool reached(double reading) const { return !(lower(reading) < *this); }
    friend constexpr bool operator==(const Expiry&, const Expiry&) = default;
    friend constexpr std::strong_ordering operator<=>(const Expiry& l, const Expiry& r) {
        return l.bits() <=> r.bits();
    }

  private:
    constexpr explicit Expiry(Truncated_double half) : half_(half) {}
    Truncated_double half_;
};

}  // namespace annulus
