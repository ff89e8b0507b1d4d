// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/svg_plot.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// Groups of two curves or more of a plot, by their numbers, that lie upon one another: nowhere further apart than
/// two lines are thick. Of curves over the same x. O(number of curves, times that of groups, times points).
[[nodiscard]] std::vector<std::vector<std::size_t>> coinciding_curves(const Plot& plot);

/// A sentence, after a blank, for each plot that has such curves; one for all plots where they are the same in each.
[[nodiscard]] std::string on_coinciding_curves(const std::vector<Plot>& plots);

}  // namespace annulus::inline v1
