// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// Where to begin the search for an array of sites in a table with open addressing. The size of the table is a power
/// of two, at least 2. Depends on vertices only: different sites of one vertex are distinguished by comparison.
template <class Sites>
[[nodiscard]] std::size_t first_place(const Sites& sites, std::size_t places) {
    std::uint64_t key = 0;
    for (const auto& s : sites) key = (key ^ static_cast<std::uint32_t>(s.vertex)) * 0x9e3779b97f4a7c15ULL;
    return static_cast<std::size_t>(key >> (64 - std::countr_zero(places)));
}

}  // namespace annulus::inline v1
