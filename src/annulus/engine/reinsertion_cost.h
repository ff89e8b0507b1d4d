// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/cost_model.h>
#include <annulus/mesh/corner_table.h>

#include <algorithm>

namespace annulus::inline v1 {

/// The cost of removing v and inserting it again: the cavity is filled with the triangulation of its neighbours,
/// which in 2D takes the square of their number in bad cases.
template <int d>
[[nodiscard]] double reinsertion_cost(const Corner_table<d>& t, Index v) {
    constexpr double filled = d == 2 ? 60.0 : 100.0;
    double cells = 0.0;
    t.for_each_corner(v, [&cells](Corner_index) { ++cells; });
    const double filling = d == 2 ? filled * cells + 0.14 * cells * cells : filled * cells;
    return std::max(Cost_model<d>::reinsertion, filling);
}

}  // namespace annulus::inline v1
