// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/parallel_inserter.h>

#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <atomic>

namespace annulus::inline v1 {

template <int d>
void Parallel_inserter<d>::insert(Inserter<d>& alone, std::span<const std::uint8_t> part, std::size_t parts,
                                  std::vector<Rank>& pending) {
    constexpr std::size_t cells_a_vertex = d == 2 ? 2 : 7, spare = 2048;
    const int threads = static_cast<int>(parts);
    typename Inserter<d>::Cells& cells = alone.cells();
    cells.make_room(cells.used + cells_a_vertex * pending.size() + spare * parts);
    find_owners(cells, part, threads);
    if (inserters_.size() < parts) inserters_.resize(parts);
    if (parts_.size() < parts) parts_.resize(parts);
    for (Part& p : parts_) p.pending.clear();
    for (const Rank v : pending) parts_[part[static_cast<std::size_t>(v)]].pending.push_back(v);

    std::atomic<std::size_t> unused = cells.used;
    for_each_run(parts, 1, threads, [&](std::size_t k, std::size_t) { start_in(k, alone, unused); });
    for_each_run(parts, 1, threads, [&](std::size_t k, std::size_t) { insert_in_partition(k); });
    cells.used = std::min(unused.load(), cells.room());
    pending.clear();
    for (std::size_t k = 0; k < parts; ++k) {
        if (parts_[k].has_start) alone.go_on_from(inserters_[k]);
        pending.insert(pending.end(), parts_[k].pending.begin(), parts_[k].pending.end());
    }
}

/// A corner of the first cell may be a vertex of a later round, which belongs to no thread.
template <int d>
void Parallel_inserter<d>::find_owners(const typename Inserter<d>::Cells& cells, std::span<const std::uint8_t> part,
                                       int threads) {
    constexpr std::size_t run = 1U << 14;
    constexpr Thread_partition::Owner no_owner = Thread_partition::no_owner;
    owner_.resize(cells.room());
    for_each_run(cells.used, run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t c = first; c < last; ++c) {
            const auto& vertices = cells.cells[c].vertex;
            const auto part_of = [&](Rank v) {
                return static_cast<std::size_t>(v) < part.size() ? part[static_cast<std::size_t>(v)] : no_owner;
            };
            const Thread_partition::Owner owner = part_of(vertices[vertices[0] == cells.infinity ? 1 : 0]);
            bool all = true;
            for (const Rank v : vertices) all = all && (v == cells.infinity || part_of(v) == owner);
            owner_[c] = all ? owner : no_owner;
        }
    });
}

/// Searches for cells to start from. Meanwhile no thread changes a cell.
template <int d>
void Parallel_inserter<d>::start_in(std::size_t k, const Inserter<d>& alone, std::atomic<std::size_t>& unused) {
    Part& part = parts_[k];
    Inserter<d>& inserter = inserters_[k];
    inserter.start_in({owner_.data(), static_cast<Thread_partition::Owner>(k), &unused}, alone);
    part.starts.clear();
    part.has_start = false;
    for (std::size_t i = 0; i < part.pending.size(); i += stretch) {
        part.starts.push_back(inserter.start_near(part.pending[i]));
        part.has_start = part.has_start || part.starts.back() != Inserter<d>::Cells::no_cell;
    }
}

/// When a walk leaves the partition, it starts again from a cell near by, as long as that helps: otherwise a cell from
/// which all walks leave would be the start of all later ones.
template <int d>
void Parallel_inserter<d>::insert_in_partition(std::size_t k) {
    using Outcome = typename Inserter<d>::Outcome;
    Part& part = parts_[k];
    if (!part.has_start) return;
    const auto& starts = part.starts;
    Inserter<d>& inserter = inserters_[k];
    const auto is_cell = [](Cell c) { return c != Inserter<d>::Cells::no_cell; };
    inserter.start_at(*std::find_if(starts.begin(), starts.end(), is_cell));
    std::size_t postponed = 0;
    bool helps = false;
    for (std::size_t i = 0; i < part.pending.size(); ++i) {
        const Rank v = part.pending[i];
        const Cell start = starts[i / stretch];
        if (i % stretch == 0) helps = start != Inserter<d>::Cells::no_cell;
        Outcome outcome = inserter.insert_in_partition(v);
        if (outcome == Outcome::lost && helps) {
            inserter.start_at(start);
            outcome = inserter.insert_in_partition(v);
            helps = outcome != Outcome::lost;
        }
        if (outcome != Outcome::inserted) part.pending[postponed++] = v;
    }
    part.pending.resize(postponed);
}

template class Parallel_inserter<2>;
template class Parallel_inserter<3>;

}  // namespace annulus::inline v1
