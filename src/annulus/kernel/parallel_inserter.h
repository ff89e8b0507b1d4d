// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/default_init_vector.h>
#include <annulus/kernel/inserter.h>
#include <annulus/kernel/thread_partition.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Inserts vertices by several threads at once, each within a partition of its own (Thread_partition). Memory is kept
/// from one call to the next.
template <int d>
class Parallel_inserter {
  public:
    using Rank = typename Inserter<d>::Rank;
    static constexpr std::size_t most_parts = 64;

    /// Inserts those of `pending` whose insertion changes no more than one partition, and leaves the others in it.
    /// `part` says by vertex whose partition it is in, for those that `alone` has inserted and those pending. These are
    /// near one another where they follow one another, for the most part. Throws what Inserter does; then the cells are
    /// no triangulation.
    void insert(Inserter<d>& alone, std::span<const std::uint8_t> part, std::size_t parts, std::vector<Rank>& pending);

  private:
    using Cell = typename Inserter<d>::Cell;
    /// What is one thread's, in cache lines of its own.
    struct alignas(128) Part {
        std::vector<Rank> pending;
        std::vector<Cell> starts;  ///< a cell of the partition near each `stretch`-th of the pending; or no_cell
        bool has_start;            ///< there is such a cell
    };
    static constexpr std::size_t stretch = 256;

    void find_owners(const typename Inserter<d>::Cells& cells, std::span<const std::uint8_t> part, int threads);
    void start_in(std::size_t k, const Inserter<d>& alone, std::atomic<std::size_t>& unused);
    void insert_in_partition(std::size_t k);

    std::vector<Inserter<d>> inserters_;
    std::vector<Part> parts_;
    Default_init_vector<Thread_partition::Owner> owner_;  // by cell
};

extern template class Parallel_inserter<2>;
extern template class Parallel_inserter<3>;

}  // namespace annulus
