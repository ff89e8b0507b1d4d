// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>

#include <vector>

namespace annulus::inline v1 {

/// The points without those that are, rounded to the grid of the box, images of points before them. O(n log n). Throws
/// not_finite, and out_of_domain for a point more than 2^29 boxes away.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> distinct_in_box(std::vector<Coordinates<d>> x, const Box<d>& box);

extern template std::vector<Coordinates<2>> distinct_in_box<2>(std::vector<Coordinates<2>>, const Box<2>&);
extern template std::vector<Coordinates<3>> distinct_in_box<3>(std::vector<Coordinates<3>>, const Box<3>&);

}  // namespace annulus::inline v1
