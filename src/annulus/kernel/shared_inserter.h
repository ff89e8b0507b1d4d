// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/inserter.h>
#include <annulus/kernel/territory.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Inserts vertices by several threads at once, each within a territory of its own (Territory). Memory is kept from one
/// call to the next.
template <int d>
class Shared_inserter {
  public:
    using Rank = typename Inserter<d>::Rank;
    static constexpr std::size_t most_parts = 32;  ///< owners are bits

    /// Inserts those of `pending` whose insertion changes no more than one territory, and leaves the others in it.
    /// `part` says by vertex whose territory it is in, for those that `alone` has inserted and those pending. These are
    /// near one another where they follow one another, for the most part. Throws what Inserter does; then the cells are
    /// no triangulation.
    void insert(Inserter<d>& alone, std::span<const std::uint8_t> part, std::size_t parts, std::vector<Rank>& pending);

  private:
    using Cell = typename Inserter<d>::Cell;
    /// What is one thread's, in cache lines of its own.
    struct alignas(128) Part {
        std::vector<Rank> pending;
        std::vector<Cell> starts;  ///< a cell of the territory near each `stretch`-th of the pending; or no_cell
        bool settled;              ///< there is such a cell
    };
    static constexpr std::size_t stretch = 256;

    void settle(std::size_t k, const Inserter<d>& alone, std::atomic<std::size_t>& unused);
    void insert_at_home(std::size_t k);

    std::vector<Inserter<d>> inserters_;
    std::vector<Part> parts_;
    std::vector<std::uint32_t> owner_;  // by vertex (Territory)
};

extern template class Shared_inserter<2>;
extern template class Shared_inserter<3>;

}  // namespace annulus
