// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>

#include <span>
#include <vector>

namespace annulus::python {

/// A snapshot of the simplices of a mesh. It never changes, so that arrays may refer to it as long as they exist.
template <int d>
struct Cells {
    /// `is_vertex` has a flag for each index.
    Cells(const Moving_mesh<d>& mesh);

    int dimension;                  ///< affine dimension of the points; -1 without points
    Mesh_cells<d> simplices;        ///< empty unless the points span d dimensions
    std::vector<Index> flat;        ///< simplices of flat points, dimension + 1 vertices each
    std::vector<Index> simplex_of;  ///< by vertex index: one simplex of its star; -1 without one
};

/// The facets of the convex hull, d vertices each: in 2D with the triangulation to their left, in 3D counter-clockwise
/// seen from outside.
template <int d>
[[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull_of(const Cells<d>& cells);

/// The vertices that each vertex is joined to by an edge: the neighbours of vertex v are index[begin[v]] to
/// index[begin[v + 1] - 1], in ascending order.
struct Adjacency {
    std::vector<Index> begin, index;
};
template <int d>
[[nodiscard]] Adjacency adjacency_of(const Cells<d>& cells);

/// For each point a simplex that contains it, inside or on its boundary; -1 outside the convex hull, and for NaN.
/// Exact: decided by the signs of determinants that the library computes.
template <int d>
void find_simplices(const Cells<d>& cells, std::span<const Coordinates<d>> vertices,
                    std::span<const Coordinates<d>> points, std::span<Index> out);

}  // namespace annulus::python
