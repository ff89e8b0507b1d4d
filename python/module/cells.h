// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>

#include <span>
#include <vector>

namespace annulus::python {

/// The simplices of a mesh at one moment; never changed, so that arrays may look into it as long as they like.
template <int d>
struct Cells {
    /// `is_vertex` has a flag for each index.
    Cells(const Moving_mesh<d>& mesh);

    int dimension;                  ///< that the points span; -1 without points
    Mesh_cells<d> simplices;        ///< none unless the points span the space
    std::vector<Index> flat;        ///< dimension + 1 vertices a simplex of points that do not
    std::vector<Index> simplex_of;  ///< by vertex index, one of those around it; -1 without one
};

/// The facets with nothing beyond, d vertices each: in 2D with the triangulation to their left, in 3D
/// counter-clockwise as seen from outside.
template <int d>
[[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull_of(const Cells<d>& cells);

/// Who is joined to whom by an edge: the neighbours of vertex v are index[begin[v]] to index[begin[v + 1] - 1], in
/// ascending order.
struct Adjacency {
    std::vector<Index> begin, index;
};
template <int d>
[[nodiscard]] Adjacency adjacency_of(const Cells<d>& cells);

/// The simplex that holds each of some points, itself or its border; -1 outside the convex hull, and for NaN. Exact:
/// decided by signs of determinants as the library computes them.
template <int d>
void find_simplices(const Cells<d>& cells, std::span<const Coordinates<d>> vertices,
                    std::span<const Coordinates<d>> points, std::span<Index> out);

}  // namespace annulus::python
