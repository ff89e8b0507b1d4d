// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/space/site.h>

#include <compare>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// The label of a site in a periodic box: which image of a vertex it is, as the integers by which the vectors of a
/// lattice are multiplied. Packed into 32 bits, o_0 + 2^10 o_1 + 2^20 o_2, each below 512 in magnitude, so that sums
/// and differences are one operation. The order is that of the packed integers: translating two offsets keeps it.
template <int d>
class Offset {
  public:
    static constexpr std::int32_t limit = 512;

    constexpr Offset() = default;
    /// Precondition: fits(o).
    explicit constexpr Offset(const Shift<d>& o) {
        for (std::size_t i = d; i-- > 0;) packed_ = packed_ * (2 * limit) + o[i];
    }
    [[nodiscard]] static constexpr bool fits(const Shift<d>& o) {
        for (const std::int32_t c : o)
            if (c <= -limit || c >= limit) return false;
        return true;
    }
    /// The offset of which this many times is `sum`, a sum of packed offsets.
    [[nodiscard]] static constexpr Offset fraction(std::int64_t sum, int parts) {
        Offset o;
        o.packed_ = static_cast<std::int32_t>(sum / parts);
        return o;
    }

    [[nodiscard]] constexpr Shift<d> unpacked() const {
        Shift<d> o{};
        std::int32_t left = packed_;
        for (std::size_t i = 0; i < d; ++i) {
            o[i] = ((left + limit) & (2 * limit - 1)) - limit;
            left = (left - o[i]) / (2 * limit);
        }
        return o;
    }
    [[nodiscard]] constexpr std::int32_t packed() const { return packed_; }
    [[nodiscard]] constexpr bool is_zero() const { return packed_ == 0; }

    friend constexpr Offset operator+(Offset a, Offset b) {
        a.packed_ += b.packed_;
        return a;
    }
    friend constexpr Offset operator-(Offset a, Offset b) {
        a.packed_ -= b.packed_;
        return a;
    }
    friend constexpr auto operator<=>(Offset, Offset) = default;

  private:
    std::int32_t packed_ = 0;
};

/// A corner of a cell in a periodic box.
template <int d>
using Image = Site_of<Offset<d>>;

}  // namespace annulus::inline v1
