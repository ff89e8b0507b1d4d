// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// The cells that one of several threads may change in Growing_cells while others change the rest. Each finite vertex
/// belongs to one thread; a cell belongs to the thread that all its finite vertices belong to.
///
/// A thread changes its own cells, and in their neighbours the half-facet that they share. Of the neighbours it reads
/// vertices and sphere. A neighbour of its own cell has only one other vertex, so it belongs to the same thread or to
/// none; and in cells that belong to none, nothing changes but such half-facets. So plain loads and stores suffice. An
/// insertion that would need more is postponed.
struct Thread_partition {
    using Owner = std::uint8_t;
    static constexpr Owner no_owner = 255;
    Owner* owner = nullptr;  ///< by cell, for all allocated ones; a thread enters the cells it takes
    Owner own = 0;
    std::atomic<std::size_t>* unused = nullptr;  ///< cells from there on belong to no thread

    [[nodiscard]] bool has(std::uint32_t cell) const { return owner[cell] == own; }
};

}  // namespace annulus::inline v1
