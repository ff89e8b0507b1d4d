// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

namespace annulus::inline v1 {

/// Every limit that a run can reach. What happens there is tested by a second build of the library, which passes each
/// limit many times in a second (Tiny_limits, chosen by the macro ANNULUS_TINY_LIMITS).
struct Wide_limits {
    static constexpr bool tiny = false;
    /// Cells of a triangulation: a corner is 4 * cell + slot and has to fit an Index. Error(too_large) beyond.
    static constexpr std::int32_t cells = std::int32_t{1} << 29;
    /// Vertices, checked on entry. In 2D the limit of cells is reached first.
    static constexpr std::size_t vertices = std::size_t{1} << 29;
    /// The least number of vertices of a round of insertion that justifies a thread (Builder).
    static constexpr std::size_t shared_part = 4096;
    /// Steps that stamps can tell apart; after that many all stamps are cleared and counting starts again.
    static constexpr std::uint32_t stamps = std::numeric_limits<std::uint32_t>::max();
    /// Certificates that a vertex lists individually; the others are covered by one bound (Expiry_list).
    [[nodiscard]] static constexpr std::size_t listed(int d) { return d == 2 ? 6 : 10; }
    /// The bits of the upper half of a double that are kept: the sign, 11 of exponent, 20 of significand
    /// (Truncated_double).
    static constexpr std::uint32_t half_mask = 0xFFFFFFFF;
    /// When the path length of a vertex is this many times what is left of its certificates, it is rebased to start at
    /// 0 again (Displacement_budget::rebase).
    static constexpr double path_ratio = 0x1p8;
    /// The least fraction of a tolerance that is recovered after it was stored as an expiry.
    static constexpr double kept = 1.0 - 0x1p-10;
};

/// Limits that every run passes: stamps wrap at every third step, lists name one or two certificates, expiries have
/// four significant bits, path lengths start again at almost every step. The number of cells can be set, since few
/// inputs fit a small one.
struct Tiny_limits {
    static constexpr bool tiny = true;
    static inline std::int32_t cells = std::int32_t{1} << 29;
    static inline std::size_t vertices = std::size_t{1} << 29;
    static constexpr std::size_t shared_part = 4;
    static constexpr std::uint32_t stamps = 3;
    [[nodiscard]] static constexpr std::size_t listed(int d) { return d == 2 ? 1 : 2; }
    static constexpr std::uint32_t half_mask = 0xFFFE0000;
    static constexpr double path_ratio = 2.0;
    static constexpr double kept = 0.0;
};

#ifdef ANNULUS_TINY_LIMITS
using Limits = Tiny_limits;
#else
using Limits = Wide_limits;
#endif

}  // namespace annulus::inline v1
