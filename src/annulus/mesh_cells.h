// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The finite cells of a triangulation, numbered 0, 1, 2 .., and their adjacency.
template <int d>
struct Mesh_cells {
    static constexpr Index outside = -1;  ///< instead of a neighbour: beyond the hull
    /// d + 1 vertex indices for each cell, positively oriented: counter-clockwise in 2D; in 3D the first three turn
    /// left as seen from the fourth, so that det(b - a, c - a, e - a) > 0. Padded with `none` where all points are in
    /// a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> vertices;
    /// The cell beyond the facet opposite to each vertex; `outside` beyond the hull, and everywhere where all points
    /// are in a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> neighbours;
};

/// The finite cells of a triangulation at one time. Nothing changes them afterwards, so they may be shared.
template <int d>
struct Cell_lists {
    /// `cells` are those of points of this affine dimension, with vertices below `bound`. O(n).
    Cell_lists(Mesh_cells<d> cells, int dimension, std::size_t bound);

    Mesh_cells<d> cells;         ///< where the points are in a plane or on a line: padded simplices of that dimension
    int dimension;               ///< affine dimension of the points; -1 without points
    std::vector<Index> cell_of;  ///< by vertex: the first cell at it; -1 without one, and unless `dimension` is d
};

/// For every vertex the vertices that an edge joins to it, in ascending order, all lists in one array: those of v are
/// index[begin[v]] to index[begin[v + 1] - 1].
struct Vertex_neighbours {
    std::vector<Index> begin;  ///< one entry more than there are indices of vertices
    std::vector<Index> index;

    /// Valid as long as this object is not changed.
    [[nodiscard]] std::span<const Index> of(Index v) const {
        const auto k = static_cast<std::size_t>(v);
        return {index.data() + begin[k], static_cast<std::size_t>(begin[k + 1] - begin[k])};
    }
};

/// What the certificates of a triangulation measure at given positions, in the caller's unit of length.
struct Measures {
    std::vector<double> tolerance;      ///< by vertex index: least certified tolerance of its certificates; infinite
                                        ///< where the points are flat, NaN at free indices
    std::vector<double> annulus_width;  ///< certified width of the annulus of every finite bi-cell: the standard one
                                        ///< in 2D, the least of four in 3D
    double theta_min = 1.5707963267948966;  ///< least theta of a finite bi-cell in radians
};

extern template struct Cell_lists<2>;
extern template struct Cell_lists<3>;

}  // namespace annulus::inline v1
