// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <span>

namespace annulus::inline v1 {

/// Whether a is nearer to q than b is, exactly. Precondition: rounding is to nearest.
template <int d>
[[nodiscard]] bool is_nearer(const Coordinates<d>& q, const Coordinates<d>& a, const Coordinates<d>& b);

/// For each query the vertex of a Delaunay triangulation that is nearest to it; of several, any of them. Exact: a walk
/// from neighbour to neighbour, each nearer than the last one, and the last vertex has no neighbour that is nearer.
///
/// `found` has, for each query, a vertex from which the walk begins, or -1: then it begins where the last walk ended.
/// O(1) from a corner of the cell that contains the query; otherwise O(n^(1/d)) expected. Preconditions: there is a
/// vertex, `first`; points and queries are in the coordinate domain, rounding is to nearest.
template <int d>
void nearest_vertices(std::span<const Coordinates<d>> points, const Vertex_neighbours& neighbours, Index first,
                      std::span<const Coordinates<d>> queries, std::span<Index> found);

extern template bool is_nearer<2>(const Coordinates<2>&, const Coordinates<2>&, const Coordinates<2>&);
extern template bool is_nearer<3>(const Coordinates<3>&, const Coordinates<3>&, const Coordinates<3>&);
extern template void nearest_vertices<2>(std::span<const Coordinates<2>>, const Vertex_neighbours&, Index,
                                         std::span<const Coordinates<2>>, std::span<Index>);
extern template void nearest_vertices<3>(std::span<const Coordinates<3>>, const Vertex_neighbours&, Index,
                                         std::span<const Coordinates<3>>, std::span<Index>);

}  // namespace annulus::inline v1
