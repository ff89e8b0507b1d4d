// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/mesh_cells.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The finite cells of a triangulation at one time. Nothing changes them afterwards, so they may be shared.
template <int d>
struct Cell_lists {
    /// `cells` are those of points of this affine dimension, with vertices below `bound`. O(n).
    Cell_lists(Mesh_cells<d> cells, int dimension, std::size_t bound);

    Mesh_cells<d> cells;         ///< where the points are in a plane or on a line: padded simplices of that dimension
    int dimension;               ///< affine dimension of the points; -1 without points
    std::vector<Index> cell_of;  ///< by vertex: the first cell at it; -1 without one, and unless `dimension` is d
};

/// The vertices of the facets of the convex hull: in 2D edges with the triangulation on their left, in 3D triangles
/// that are counter-clockwise seen from outside. In the order of the cells behind them. Empty unless the points span d
/// dimensions. O(n).
template <int d>
[[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull_facets(const Cell_lists<d>& lists);

/// For every vertex the vertices that an edge joins to it, in ascending order, all lists in one array: those of v are
/// index[begin[v]] to index[begin[v + 1] - 1].
struct Vertex_neighbours {
    std::vector<Index> begin;  ///< one entry more than there are indices of vertices
    std::vector<Index> index;

    [[nodiscard]] std::span<const Index> of(Index v) const {
        const auto k = static_cast<std::size_t>(v);
        return {index.data() + begin[k], static_cast<std::size_t>(begin[k + 1] - begin[k])};
    }
};
/// Also of points in a plane or on a line. O(n).
template <int d>
[[nodiscard]] Vertex_neighbours vertex_neighbours(const Cell_lists<d>& lists);

/// For each of `points` the number of a cell that contains it, in its interior or on its border; -1 outside the convex
/// hull, for NaN and infinity, and unless the vertices span d dimensions. Exact. A walk begins at the nearest of some
/// cbrt(n) vertices and of the cell found last; expected O(cbrt(n)) for each point, more along a walk through
/// clusters. x: positions by vertex. Precondition: points.size() == out.size(), rounding to nearest.
template <int d>
void find_cells(const Cell_lists<d>& lists, std::span<const Coordinates<d>> x, std::span<const Coordinates<d>> points,
                std::span<Index> out);

extern template struct Cell_lists<2>;
extern template struct Cell_lists<3>;

}  // namespace annulus::inline v1
