// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/truncated_double.h>

#include <compare>
#include <cstdint>

namespace annulus {

/// A path length of a path length at which a certificate expires, rounded down: too low by 2^-20 of the path length at
/// most, which costs an evaluation now and then, never an answer. Non-negative.
class Expiry {
  public:
    constexpr Expiry() = default;  // 0
    /// The largest not above `path_length`; 0 unless that is positive.
    [[nodiscard]] static constexpr Expiry lower(double path_length) {
        return Expiry(Truncated_double::lower(path_length));
    }
    [[nodiscard]] static constexpr Expiry never() { return Expiry(Truncated_double::infinity()); }
    /// What bits() gave.
    [[nodiscard]] static constexpr Expiry of_bits(std::uint32_t bits) {
        return Expiry(Truncated_double::of_bits(bits));
    }

    [[nodiscard]] constexpr double path_length() const { return half_.value(); }
    [[nodiscard]] constexpr std::uint32_t bits() const { return half_.bits(); }
    /// path length >= this->path_length(): as this one's lower half is 0, the upper halves tell. Precondition: path
    /// length >= 0.
    [[nodiscard]] constexpr bool reached(double path_length) const { return !(lower(path_length) < *this); }
    friend constexpr bool operator==(const Expiry&, const Expiry&) = default;
    friend constexpr std::strong_ordering operator<=>(const Expiry& l, const Expiry& r) {
        return l.bits() <=> r.bits();
    }

  private:
    constexpr explicit Expiry(Truncated_double half) : half_(half) {}
    Truncated_double half_;
};

}  // namespace annulus
