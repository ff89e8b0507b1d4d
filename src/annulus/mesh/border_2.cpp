// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/border.h>

namespace annulus::inline v1 {

/// Walks the border clockwise, around infinity. The border turns right everywhere, so it winds as often as its
/// direction enters the half-plane of directions that point up, or right when level.
bool border_winds_once(const Corner_table<2>& t, std::span<const Coordinates<2>> positions, std::size_t& seen) {
    const Corner_index first = t.corner_of_infinity();
    const auto points_up = [&](Corner_index h) {
        const Coordinates<2>& from = positions[static_cast<std::size_t>(t.vertex(t.ccw(h)))];
        const Coordinates<2>& to = positions[static_cast<std::size_t>(t.vertex(t.cw(h)))];
        return from[1] < to[1] || (from[1] == to[1] && from[0] < to[0]);
    };
    int entries = 0;
    bool before = points_up(first);
    Corner_index h = first;
    do {
        h = t.next_around(h);
        ++seen;
        const bool now = points_up(h);
        if (now && !before) ++entries;
        before = now;
    } while (h != first);
    return entries == 1;
}

}  // namespace annulus::inline v1
