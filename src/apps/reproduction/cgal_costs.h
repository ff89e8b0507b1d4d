// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/certificate_survey.h>

// The time that CGAL needs for the operations that the paper measures: processor time of one thread.
namespace annulus::inline v1 {

/// Seconds of CGAL's insertion of a range into an empty triangulation: the paper's rebuilding. Making the points
/// beforehand and destroying the object afterwards are not counted.
template <int d>
[[nodiscard]] double time_range_insertion(std::span<const Coordinates<d>> x);

/// Seconds of relocating all vertices from `before` to `target`, one after another: a point is inserted at the target,
/// located from the vertex, then the vertex is removed. This is the paper's relocation. Building the triangulation is
/// not counted. Throws Error(duplicate_point) if a target is the position of another vertex at that moment.
template <int d>
[[nodiscard]] double time_relocation(std::span<const Coordinates<d>> before, std::span<const Coordinates<d>> target);

/// Seconds of removing a vertex, and of inserting one where a neighbour is known: means over a tenth of the vertices,
/// which are removed one after another and then inserted again, so that the triangulation is always similar to the
/// original.
template <int d>
[[nodiscard]] Operation_record time_operations(const Moving_of<d>& dt);

extern template double time_range_insertion<2>(std::span<const Coordinates<2>>);
extern template double time_range_insertion<3>(std::span<const Coordinates<3>>);
extern template double time_relocation<2>(std::span<const Coordinates<2>>, std::span<const Coordinates<2>>);
extern template double time_relocation<3>(std::span<const Coordinates<3>>, std::span<const Coordinates<3>>);
extern template Operation_record time_operations<2>(const Moving_delaunay_2&);
extern template Operation_record time_operations<3>(const Moving_delaunay_3&);

}  // namespace annulus::inline v1
