// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The C++ standard that every header here needs. Every public header in C++ includes this one first, so that a compiler
// with an older standard reports this error, not errors about the standard library.
#if __cplusplus < 202002L
#error "annulus: compile with -std=c++20 or a later standard"
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace annulus::inline v1 {

/// Position of a point in R^d, in the caller's unit of length: plain doubles, no invariant.
template <int d>
using Coordinates = std::array<double, static_cast<std::size_t>(d)>;

/// Index of a vertex in input order. 32 bits: at most 2^29 cells. Cells and corners of a Corner_table have their own
/// types (internal/index.h).
using Index = std::int32_t;

/// The vertex at infinity.
inline constexpr Index infinite = -1;
/// No vertex at all, not even infinity: pads arrays that have more entries than vertices.
inline constexpr Index none = -2;

/// The stage of the filtered predicate that gave an answer, cheapest first.
enum class Stage : std::uint8_t {
    filter,    ///< round to nearest with a proved error bound
    interval,  ///< interval arithmetic
    exact,     ///< integers, directed rounding only in the last division and square roots
};

[[nodiscard]] constexpr std::string_view name_of(Stage s) {
    return s == Stage::filter ? "filter" : s == Stage::interval ? "interval" : "exact";
}

/// How many answers each stage gave.
struct Stage_counts {
    std::uint64_t filter = 0;
    std::uint64_t interval = 0;
    std::uint64_t exact = 0;

    void count(Stage s) noexcept { ++(s == Stage::filter ? filter : s == Stage::interval ? interval : exact); }
    [[nodiscard]] std::uint64_t total() const noexcept { return filter + interval + exact; }
    Stage_counts& operator+=(const Stage_counts& o) noexcept {
        filter += o.filter;
        interval += o.interval;
        exact += o.exact;
        return *this;
    }
    friend bool operator==(const Stage_counts&, const Stage_counts&) = default;
};

}  // namespace annulus::inline v1
