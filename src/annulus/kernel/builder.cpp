// SPDX-License-Identifier: GPL-3.0-or-later
// Builder: insertion, by one thread or several.
#include <annulus/kernel/builder.h>

#include <annulus/arithmetic/duplicate_point.h>
#include <annulus/arithmetic/limits.h>
#include <annulus/kernel/bounding_box.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>

namespace annulus::inline v1 {

template <int d>
bool Builder<d>::build(std::span<const Coordinates<d>> x, std::span<const Index> vertices, int threads) {
    order_.assign(vertices.begin(), vertices.end());
    const Bounding_box<d> around(x, order_);
    spatial_order_.sort(x, around, order_, threads);
    const double scale = take_positions(x, around.extent(), threads);
    if (!find_simplex()) return false;
    first_cells();
    if (threads == 1) {
        insert_sequentially(0, order_.size());
    } else if (!insert_in_parallel(around.scaled(scale), threads)) {
        first_cells();
        insert_sequentially(0, order_.size());
    }
    return true;
}

template <int d>
void Builder<d>::throw_duplicate(Rank taken, Rank v) const {
    throw duplicate_point_error("points", "have",
                                {order_[static_cast<std::size_t>(taken)], order_[static_cast<std::size_t>(v)]});
}

template <int d>
void Builder<d>::insert_sequentially(std::size_t first, std::size_t last) {
    for (Rank v = static_cast<Rank>(first); v < static_cast<Rank>(last); ++v)
        if (!is_corner(v) && !inserter_.insert(v)) throw_duplicate(inserter_.blocker(), v);
}

/// Returns false where two vertices are at one position. Then one thread has to do it again: it always names the same
/// two.
template <int d>
bool Builder<d>::insert_in_parallel(const Bounding_box<d>& around, int threads) {
    const std::size_t n = order_.size();
    const std::size_t most = std::min(static_cast<std::size_t>(threads), Parallel_inserter<d>::most_parts);
    std::vector<Rank> pending;
    std::size_t first = 0;
    for (std::size_t last = 0; first < n; first = last) {
        while (last < n && spatial_order_.round(last) == spatial_order_.round(first)) ++last;
        pending.clear();
        for (std::size_t v = first; v < last; ++v)
            if (!is_corner(static_cast<Rank>(v))) pending.push_back(static_cast<Rank>(v));
        // Most of what is postponed at the border of a part is inside a part when the curve is moved. Less is left
        // each time, so fewer parts share it, with less border.
        std::size_t at_most = most;
        for (const double moved : {0.0, 0.25, 0.375}) {
            const std::size_t parts = std::min(at_most, pending.size() / Limits::shared_part);
            if (parts < 2) break;
            find_parts(pending, last, parts, [&](std::size_t v) {
                return moved == 0 ? spatial_order_.place(v)
                                  : Spatial_order<d>::moved_place(cells_.sites[v].x, around, moved);
            });
            const std::size_t before = pending.size();
            shared_.insert(inserter_, part_, parts, pending);
            if (pending.size() > before / 4 * 3) break;  // the cells are as large as the parts
            at_most = std::max(at_most / 2, std::size_t{2});
        }
        for (const Rank v : pending)
            if (!inserter_.insert(v)) return false;
    }
    return true;
}

/// Divides the curve so that the parts have equally many pending vertices, judging by a sample, and determines
/// the part of each vertex before `last`.
template <int d>
template <class Place>
void Builder<d>::find_parts(std::span<const Rank> pending, std::size_t last, std::size_t parts, Place place) {
    constexpr std::size_t samples = 256, run = 1U << 14;  // per part; vertices that a thread takes at once
    std::vector<std::uint64_t> sample, cuts;
    for (std::size_t i = 0; i < pending.size(); i += 1 + pending.size() / (samples * parts))
        sample.push_back(place(static_cast<std::size_t>(pending[i])));
    std::sort(sample.begin(), sample.end());
    for (std::size_t k = 1; k < parts; ++k) cuts.push_back(sample[k * sample.size() / parts]);
    part_.resize(last);
    for_each_run(last, run, static_cast<int>(parts), [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            part_[v] = static_cast<std::uint8_t>(std::upper_bound(cuts.begin(), cuts.end(), place(v)) - cuts.begin());
    });
}

template class Builder<2>;
template class Builder<3>;

}  // namespace annulus::inline v1
