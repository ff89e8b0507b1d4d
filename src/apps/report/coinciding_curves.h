// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/svg_plot.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// Groups of two curves or more of a plot, by their numbers, that lie upon one another: nowhere further apart than
/// two lines are thick. Of curves over the same x. O(number of curves, times that of groups, times points).
[[nodiscard]] std::vector<std::vector<std::size_t>> coinciding_curves(const Plot& plot);

/// A sentence, empty for a plot that has no such curves.
[[nodiscard]] std::string on_coinciding_curves(const Plot& plot);

}  // namespace annulus::inline v1
