// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Lists of cells that can be compared, without CGAL.

#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <vector>

namespace annulus::oracle {

/// Sorted. In 2D each is turned so that its least vertex comes first; edges are (a < b, none). In 3D each
/// is sorted, padded with `none` in front where points are flat.
template <int d>
using Cells_of = std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>>;

using Cell = std::array<Index, 3>;
using Cells = Cells_of<2>;

[[nodiscard]] inline Cell canonical(Cell c) {
    if (c[2] == none) return {std::min(c[0], c[1]), std::max(c[0], c[1]), none};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    return c;
}

template <std::size_t corners>
[[nodiscard]] std::array<Index, corners> canonical(std::array<Index, corners> c) {
    static_assert(corners == 4);
    std::sort(c.begin(), c.end());
    return c;
}

}  // namespace annulus::oracle
