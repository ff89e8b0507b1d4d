// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Whether clear_cells() may be called and pays: the processor has AVX2.
[[nodiscard]] bool has_fast_clear_cells();

/// Counts those of the cells [first, last) that are finite and for which excludes_all() of Circumcircle_2 or
/// Circumsphere_3 is true of the vertices opposite to their facets (a corner of the cell stands in for infinity): all
/// their certificates hold. Appends all other cells to `rest`, the finite ones in order, and up to three that are not
/// tested. Four at a time, with the same operations as those classes, so that the answers are the same.
template <int d>
[[nodiscard]] std::size_t clear_cells(const Corner_table<d>& table, std::span<const Coordinates<d>> x, Cell_index first,
                                      Cell_index last, std::vector<Cell_index>& rest);

}  // namespace annulus::inline v1
