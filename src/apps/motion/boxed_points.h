// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/motion/generated_points.h>

namespace annulus::inline v1 {

/// The square root (d = 2) or cube root (3) of a positive number, the same double on every platform: std::cbrt and
/// std::pow are not.
template <int d>
[[nodiscard]] double root_of(double x);

/// The d-th root of the box's volume per point, the unit of lengths: the same double on every platform.
template <int d>
[[nodiscard]] double spacing_in(const Box<d>& box, std::size_t n);

/// n points of a family in a periodic box; the same for a seed on every platform. Uniform points and grids are those of
/// the unit square or cube, mapped to the box. The circle or sphere, the ellipse or ellipsoid is in the middle, half as
/// wide as the box is thick. Clusters have the widths of those in the unit square or cube, times the d-th root of the
/// volume; their points may be images outside of the box.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> generate_in(const Box<d>& box, Point_family family, std::size_t n,
                                                      std::uint64_t seed);

extern template double root_of<2>(double);
extern template double root_of<3>(double);
extern template double spacing_in<2>(const Box<2>&, std::size_t);
extern template double spacing_in<3>(const Box<3>&, std::size_t);
extern template std::vector<Coordinates<2>> generate_in<2>(const Box<2>&, Point_family, std::size_t, std::uint64_t);
extern template std::vector<Coordinates<3>> generate_in<3>(const Box<3>&, Point_family, std::size_t, std::uint64_t);

}  // namespace annulus::inline v1
