// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/density_2.h>
#include <apps/motion/region_2.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// n points of the domain, independently distributed in proportion to the density, no two equal, in the order of a
/// space-filling curve (Hilbert's, by CGAL), so that neighbours are near each other in memory.
///
/// By rejection: uniform points (in the disc's square; in a polygon's triangles) are kept with probability density over
/// its bound; in an image a pixel is drawn by its weight, then a position around it, which is kept if it is in the
/// domain. The same arguments give the same points everywhere: the generator is std::mt19937_64, whose output the
/// standard fixes, and 53 bits of it make a number in [0, 1). Only `sin2` calls a library function (std::sin), whose
/// last bit could decide differently on another platform about once in 10^15 points.
///
/// O(n) expected, and for an image O(pixels). Throws what `require_density` does. Throws Error(bad_input) when a
/// million tries in a row give no new point (fewer than n doubles there).
[[nodiscard]] std::vector<Coordinates<2>> sample(const Region_2& domain, const Density_2& density, std::size_t n,
                                                 std::uint64_t seed);

}  // namespace annulus::inline v1
