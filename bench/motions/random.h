// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

namespace bench {

/// The same numbers on every machine, which the distributions of the standard library do not guarantee.
class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}
    [[nodiscard]] std::uint64_t bits() { return bits_(); }
    /// In [0, 1).
    [[nodiscard]] double unit() { return std::ldexp(static_cast<double>(bits_() >> 11), -53); }
    [[nodiscard]] double normal() {
        const double radius = std::sqrt(-2.0 * std::log(1.0 - unit()));
        return radius * std::cos(6.283185307179586 * unit());
    }

  private:
    std::mt19937_64 bits_;
};

}  // namespace bench
