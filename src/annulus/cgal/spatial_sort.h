// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <span>
#include <vector>

namespace annulus {

/// Puts indices of points in the order of CGAL's spatial sort, by at most `threads` threads. The order does not depend on their number,
/// nor does that of points at one place: ranges are split where and how one thread splits them. O(n log n).
template <int d>
void spatial_sort(std::vector<Index>& order, std::span<const Coordinates<d>> x, int threads);

extern template void spatial_sort<2>(std::vector<Index>&, std::span<const Coordinates<2>>, int);
extern template void spatial_sort<3>(std::vector<Index>&, std::span<const Coordinates<3>>, int);

}  // namespace annulus
