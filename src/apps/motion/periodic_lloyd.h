// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/types.h>

#include <vector>

namespace annulus::inline v1 {

/// From each vertex of a periodic Delaunay triangulation to the centroid of its Voronoi cell, with density 1, in the
/// unit of the points: the steps of Lloyd's iteration in a periodic box.
///
/// The cell is the sum of the signed simplices whose volumes periodic_voronoi_volumes adds up (voronoi_terms.h): each
/// spanned by the vertex, the circumcentres of two adjacent cells around it and, in 3D, the midpoint of the edge that
/// they share. All coordinates are relative to the vertex. Where a cell is thinner than rounding, so that the centroid
/// is computed outside of it, it is the mean of the circumcentres around the vertex instead.
///
/// The result depends on points, box and cells, not on the numbers of the cells, nor on the order of their corners: so
/// it is the same, bit for bit, whether a mesh was built or flipped. O(n log n), in one thread. Preconditions: cells
/// that the audit accepts, with neighbours and translations. Throws Error(bad_input) for a cell that is not positive.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> periodic_centroid_offsets(const Periodic_audit_input<d>& mesh);

extern template std::vector<Coordinates<2>> periodic_centroid_offsets(const Periodic_audit_input<2>&);
extern template std::vector<Coordinates<3>> periodic_centroid_offsets(const Periodic_audit_input<3>&);

}  // namespace annulus::inline v1
