// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// Whether the border of a triangulation, at x, winds once (docs/theory.md 1.2). Precondition: every ridge of it is
/// convex there. O(border); in 3D it also fills O(cells) bytes. The number of facets read is added to `seen`.
[[nodiscard]] bool border_winds_once(const Corner_table<2>& t, std::span<const Coordinates<2>> x, std::size_t& seen);
[[nodiscard]] bool border_winds_once(const Corner_table<3>& t, std::span<const Coordinates<3>> x, std::size_t& seen);

/// Whether all infinite cells form one border. Flips keep the border connected; the rebuild of a cavity beneath it may
/// have closed off a part, which would then wind by itself. O(cells).
template <int d>
[[nodiscard]] bool border_is_whole(const Corner_table<d>& t) {
    std::size_t all = 0;
    for (const Cell_index c : t.cells())
        if (t.is_infinite(c)) ++all;
    std::size_t met = 0;
    if constexpr (d == 2) {
        const Corner_index first = t.corner_of_infinity();
        Corner_index h = first;
        do {
            ++met;
            h = t.next_around(h);
        } while (h != first);
    } else {
        t.for_each_corner(infinite, [&met](Corner_index) { ++met; });
    }
    return met == all;
}

}  // namespace annulus::inline v1
