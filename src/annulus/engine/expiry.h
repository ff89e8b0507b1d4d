// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/truncated_double.h>

#include <compare>
#include <cstdint>

namespace annulus::inline v1 {

/// The path length at which a certificate expires, rounded down: too low by at most 2^-20 of the path length. This
/// costs an evaluation now and then, but never changes an answer. Non-negative.
class Expiry {
  public:
    constexpr Expiry() = default;  // 0
    /// The largest expiry not above `path_length`; 0 unless that is positive.
    [[nodiscard]] static constexpr Expiry lower(double path_length) {
        return Expiry(Truncated_double::lower(path_length));
    }
    [[nodiscard]] static constexpr Expiry never() { return Expiry(Truncated_double::infinity()); }
    /// The inverse of bits().
    [[nodiscard]] static constexpr Expiry of_bits(std::uint32_t bits) {
        return Expiry(Truncated_double::of_bits(bits));
    }

    [[nodiscard]] constexpr double path_length() const { return half_.value(); }
    [[nodiscard]] constexpr std::uint32_t bits() const { return half_.bits(); }
    /// Whether path_length >= this->path_length(). The lower half of this one is 0, so the upper halves decide.
    /// Precondition: path_length >= 0.
    [[nodiscard]] constexpr bool reached(double path_length) const { return !(lower(path_length) < *this); }
    friend constexpr bool operator==(const Expiry&, const Expiry&) = default;
    friend constexpr std::strong_ordering operator<=>(const Expiry& l, const Expiry& r) {
        return l.bits() <=> r.bits();
    }

  private:
    constexpr explicit Expiry(Truncated_double half) : half_(half) {}
    Truncated_double half_;
};

}  // namespace annulus::inline v1
