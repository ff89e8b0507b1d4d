// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/audit.h>

#include <array>
#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// An exact verdict on a triangulation made by any program: whether the cells are a Delaunay triangulation of the
/// points. It is given as arrays, such as `points` and `simplices` of scipy.spatial.Delaunay: d + 1 indices into
/// `points` for each cell, in any order, so the orientation of a cell does not matter. If all points are in a plane or
/// on a line, cells may be simplices of that dimension, padded with `none`.
///
/// What is examined: every index names a point; no cell is flat; no two cells are on one side of a facet; every facet
/// is locally Delaunay; the cells fill the convex hull, once; every point is a vertex; no two points coincide.
/// Cospherical points are no fault. Together these decide the question (docs/theory.md 1), in integer arithmetic, with
/// code that the triangulations of this library do not use.
///
/// The result counts all faults and lists `most_faults` of them at most, sorted by kind. Each names points by their
/// index and, for an unknown vertex, a flat cell, an overlap and a facet that is not Delaunay, also the cells by
/// theirs. `first_fault` is the text of the first one. In Audit_result::inverted_cells flat cells are counted.
///
/// Throws Error(not_finite), naming the point, and Error(too_large). O(n log n), a few microseconds for each cell;
/// longer where coordinates of very different magnitudes make long integers.
[[nodiscard]] Audit_result audit(std::span<const Coordinates<2>> points, std::span<const std::array<Index, 3>> cells,
                                 std::size_t most_faults = 100);
[[nodiscard]] Audit_result audit(std::span<const Coordinates<3>> points, std::span<const std::array<Index, 4>> cells,
                                 std::size_t most_faults = 100);

/// The same of an input whose cells have any orientation; with names and calls between (mesh/audit.h). It is modified:
/// corners are swapped.
[[nodiscard]] Audit_result audit_unoriented(Audit_input<2>& input);
[[nodiscard]] Audit_result audit_unoriented(Audit_input<3>& input);

}  // namespace annulus::inline v1
