// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/default_init_vector.h>
#include <annulus/kernel/inserter.h>
#include <annulus/kernel/thread_partition.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Inserts vertices by several threads at once, each within its own Thread_partition. Memory is kept from one call to
/// the next.
template <int d>
class Parallel_inserter {
  public:
    using Rank = typename Inserter<d>::Rank;
    static constexpr std::size_t most_parts = 64;

    /// Inserts those of `pending` whose insertion changes only one partition, and leaves the others in it. `part`
    /// gives, by vertex, the partition of those that `alone` has inserted and of those pending. Pending vertices that
    /// follow one another should be near one another, for the most part. Throws what Inserter throws; then the cells
    /// are not a triangulation.
    void insert(Inserter<d>& alone, std::span<const std::uint8_t> part, std::size_t parts, std::vector<Rank>& pending);

  private:
    using Cell = typename Inserter<d>::Cell;
    /// The data of one thread, in its own cache lines.
    struct alignas(128) Part {
        std::vector<Rank> pending;
        std::vector<Cell> starts;  ///< a cell of the partition near every `stretch`-th pending one; or no_cell
        bool has_start;            ///< whether there is such a cell
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

}  // namespace annulus::inline v1
