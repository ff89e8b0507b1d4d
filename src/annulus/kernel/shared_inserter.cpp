// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/shared_inserter.h>

#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <atomic>

namespace annulus {

template <int d>
void Shared_inserter<d>::insert(Inserter<d>& alone, std::span<const std::uint8_t> part, std::size_t parts,
                                std::vector<Rank>& pending) {
    constexpr std::size_t cells_a_vertex = d == 2 ? 2 : 7, spare = 2048, run = 1U << 14;
    const int threads = static_cast<int>(parts);
    typename Inserter<d>::Cells& cells = alone.cells();
    const auto infinity = static_cast<std::size_t>(cells.infinity);
    owner_.resize(infinity + 1);
    // A corner of the first cell may be of a later round. What an earlier build left there may be `everyone`.
    std::fill(owner_.begin() + static_cast<std::ptrdiff_t>(part.size()), owner_.end(), Territory::no_one);
    owner_[infinity] = Territory::everyone;
    for_each_run(part.size(), run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) owner_[v] = std::uint32_t{1} << part[v];
    });
    if (inserters_.size() < parts) inserters_.resize(parts);
    if (parts_.size() < parts) parts_.resize(parts);
    for (Part& p : parts_) p.pending.clear();
    for (const Rank v : pending) parts_[part[static_cast<std::size_t>(v)]].pending.push_back(v);
    cells.make_room(cells.used + cells_a_vertex * pending.size() + spare * parts);

    std::atomic<std::size_t> unused = cells.used;
    for_each_run(parts, 1, threads, [&](std::size_t k, std::size_t) { settle(k, alone, unused); });
    for_each_run(parts, 1, threads, [&](std::size_t k, std::size_t) { insert_at_home(k); });
    cells.used = std::min(unused.load(), cells.room());
    pending.clear();
    for (std::size_t k = 0; k < parts; ++k) {
        if (parts_[k].settled) alone.go_on_from(inserters_[k]);
        pending.insert(pending.end(), parts_[k].pending.begin(), parts_[k].pending.end());
    }
}

/// Looks for places to start from. While threads do so nothing changes.
template <int d>
void Shared_inserter<d>::settle(std::size_t k, const Inserter<d>& alone, std::atomic<std::size_t>& unused) {
    Part& part = parts_[k];
    Inserter<d>& inserter = inserters_[k];
    inserter.settle({owner_, std::uint32_t{1} << k, &unused}, alone);
    part.starts.clear();
    part.settled = false;
    for (std::size_t i = 0; i < part.pending.size(); i += stretch) {
        part.starts.push_back(inserter.start_near(part.pending[i]));
        part.settled = part.settled || part.starts.back() != Inserter<d>::Cells::no_cell;
    }
}

template <int d>
void Shared_inserter<d>::insert_at_home(std::size_t k) {
    Part& part = parts_[k];
    if (!part.settled) return;
    std::size_t postponed = 0;
    const auto& starts = part.starts;
    Cell start = *std::find_if(starts.begin(), starts.end(), [](Cell c) { return c != Inserter<d>::Cells::no_cell; });
    inserters_[k].start_at(start);
    for (std::size_t i = 0; i < part.pending.size(); ++i) {
        if (i % stretch == 0 && starts[i / stretch] != Inserter<d>::Cells::no_cell) start = starts[i / stretch];
        const Rank v = part.pending[i];
        if (inserters_[k].insert_at_home(v, start) != Inserter<d>::Outcome::inserted) part.pending[postponed++] = v;
    }
    part.pending.resize(postponed);
}

template class Shared_inserter<2>;
template class Shared_inserter<3>;

}  // namespace annulus
