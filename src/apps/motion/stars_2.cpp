// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/stars_2.h>

#include <algorithm>

namespace annulus::inline v1 {

namespace {

/// The vertices stored for a number of the table that is not a cell.
constexpr Index absent = none;

}  // namespace

void Stars_2::mark(const Triangle& t) {
    for (const Index v : t) {
        if (v < 0 || static_cast<std::size_t>(v) >= marked_.size() || marked_[static_cast<std::size_t>(v)] != 0)
            continue;
        marked_[static_cast<std::size_t>(v)] = 1;
        changed_.push_back(v);
    }
}

/// A star changes only with its triangles, and a new triangle differs from the one that had its number before. One that
/// has only changed its number or its first vertex makes its stars be read again.
void Stars_2::find_changed(const Corner_table<2>& table) {
    const Cell_index bound = table.cell_bound();
    for (Cell_index c = bound; triangle_.has(c); ++c) mark(triangle_[c]);
    triangle_.resize(bound.offset(), {absent, absent, absent});
    for (Cell_index c(0); c < bound; ++c) {
        Triangle now{absent, absent, absent};
        if (table.is_cell(c))
            now = {table.vertex(table.corner(c, 0)), table.vertex(table.corner(c, 1)),
                   table.vertex(table.corner(c, 2))};
        if (now == triangle_[c]) continue;
        mark(triangle_[c]);
        mark(now);
        triangle_[c] = now;
    }
}

/// The ring becomes the list of v; it is turned so that it begins at `start`.
void Stars_2::put(std::size_t v, bool open, std::size_t start) {
    Place& place = place_[v];
    const auto size = static_cast<Index>(ring_.size());
    if (size > place.room) {
        place.begin = pool_.size();
        place.room = size + 1;
        pool_.resize(pool_.size() + static_cast<std::size_t>(place.room));
    }
    const auto to = pool_.begin() + static_cast<std::ptrdiff_t>(place.begin);
    std::rotate_copy(ring_.begin(), ring_.begin() + static_cast<std::ptrdiff_t>(start), ring_.end(), to);
    place.size = size;
    place.open = open;
    place.since = readings_;
}

void Stars_2::read(const Corner_table<2>& table) {
    ++readings_;
    const auto n = static_cast<std::size_t>(table.vertex_bound());
    changed_.clear();
    // Lists that have moved to the end leave gaps; when the gaps are as large as the lists, all are read again, without
    // gaps.
    if (place_.size() != n || pool_.size() > 16 * n) {
        place_.assign(n, {});
        pool_.clear();
        triangle_.clear();
    }
    marked_.assign(n, 0);
    find_changed(table);
    if (changed_.size() > n / 2) std::sort(changed_.begin(), changed_.end());  // their lists in this order, too
    for (const Index v : changed_) {
        ring_.clear();
        bool open = false;
        std::size_t start = 0;
        if (table.corner_of(v) == no_corner) open = true;
        else
            table.for_each_corner(v, [&](Corner_index h) {
                const Index u = table.vertex(table.ccw(h));
                if (u == infinite) {
                    open = true;
                    start = ring_.size();
                } else {
                    ring_.push_back(u);
                }
            });
        if (!open) start = static_cast<std::size_t>(std::min_element(ring_.begin(), ring_.end()) - ring_.begin());
        put(static_cast<std::size_t>(v), open, start);
    }
}

void Stars_2::read(const Neighbours_2& lists) {
    ++readings_;
    const std::size_t n = lists.size();
    place_.assign(n, {});
    pool_.clear();
    triangle_.clear();
    for (std::size_t v = 0; v < n; ++v) {
        const auto of = lists.of(v);
        ring_.assign(of.begin(), of.end());
        const bool open = lists.hull[v] != 0 || of.empty();
        put(v, open, open ? 0 : static_cast<std::size_t>(std::min_element(ring_.begin(), ring_.end()) - ring_.begin()));
    }
}

}  // namespace annulus::inline v1
