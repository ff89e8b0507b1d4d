// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

namespace annulus {

/// What one of several threads may change of Growing_cells while others change the rest. Each vertex belongs to one of
/// them or to none, infinity to all; a cell belongs to the thread that all its vertices belong to.
///
/// A thread changes cells of its own, and of their neighbours the half-facet that they share. Of these it reads
/// vertices and sphere: a neighbour of a cell of its own has but one vertex more, so it is its own or no thread's, and
/// nothing of the latter changes but such half-facets. So plain loads and stores do. What would take more is postponed.
struct Territory {
    static constexpr std::uint32_t everyone = ~std::uint32_t{0};
    static constexpr std::uint32_t no_one = 0;
    std::span<const std::uint32_t> owner;        ///< by vertex, a bit each; of infinity `everyone`
    std::uint32_t own = everyone;                ///< the bit of this thread
    std::atomic<std::size_t>* unused = nullptr;  ///< cells from there on are no one's

    template <std::size_t corners>
    [[nodiscard]] bool has(const std::array<std::int32_t, corners>& vertices) const {
        std::uint32_t all = own;
        for (const std::int32_t v : vertices) all &= owner[static_cast<std::size_t>(v)];
        return all != 0;
    }
};

}  // namespace annulus
