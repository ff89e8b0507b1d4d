// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace annulus {

/// What one of several threads may change of Growing_cells while others change the rest. Each finite vertex belongs to
/// one of them; a cell belongs to the thread that all its finite vertices belong to.
///
/// A thread changes cells of its own, and of their neighbours the half-facet that they share. Of these it reads
/// vertices and sphere: a neighbour of a cell of its own has but one vertex more, so it is its own or no thread's, and
/// nothing of the latter changes but such half-facets. So plain loads and stores do. What would take more is postponed.
struct Thread_partition {
    using Owner = std::uint8_t;
    static constexpr Owner no_owner = 255;
    Owner* owner = nullptr;  ///< by cell, for as many as there is room for; a thread writes down what it takes
    Owner own = 0;
    std::atomic<std::size_t>* unused = nullptr;  ///< cells from there on are no one's

    [[nodiscard]] bool has(std::uint32_t cell) const { return owner[cell] == own; }
};

}  // namespace annulus
