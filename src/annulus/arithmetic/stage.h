// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cstdint>
#include <string_view>

namespace annulus::inline v1 {

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
