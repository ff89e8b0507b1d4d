// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh_cells.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The guarantee of voronoi_volumes: the relative error of every finite number.
inline constexpr double voronoi_volume_error = 0x1p-33;

/// How the Voronoi cells of a run were computed.
struct Voronoi_counts {
    std::size_t bounded = 0;  ///< bounded Voronoi cells
    std::size_t exact = 0;    ///< of these, computed exactly because doubles were not accurate enough
};

/// The areas (d = 2) or volumes (d = 3) of the Voronoi cells of a Delaunay triangulation, by vertex index, in the
/// caller's unit of length to the d-th power. Infinity where the Voronoi cell is unbounded: at every vertex of the
/// hull, those within its edges and facets included, and everywhere if all points are in a plane or on a line. NaN for
/// an index that no cell names: a free index, and a vertex that is the only one.
///
/// Each number has a relative error of at most voronoi_volume_error, 1.2e-10 (most have 1e-13), whatever the points:
/// near-cospherical, slivers, and at any scale. A number above the largest double is replaced by the largest double, so
/// that infinity always means unbounded; one below the smallest normal double has an absolute error of 2^-1074 besides.
///
/// Method: a volume is a sum over facets of terms in circumcentres (voronoi_terms.h), in doubles, each with a bound of
/// its error. Circumcentres for which doubles are not accurate enough are computed exactly and rounded. Sums whose
/// final bounds are too large are recomputed from exact circumcentres. Results are a function of points and cells, in
/// their order.
///
/// O(n): a microsecond per vertex in 3D, 0.1 ms for one that is computed exactly; 32 bytes of work space per cell (24
/// in 2D). Preconditions: the cells are a Delaunay triangulation of the points they name, as Moving_mesh::cells() gives
/// it. Where they are positive but not Delaunay (tolerances that are not certified) volumes are those of signed sums.
/// Elements of `points` at indices that no cell names are not read. Throws Error: unknown_vertex for an index outside
/// `points`, not_finite and out_of_domain for positions, wrong_size unless each cell has neighbours, bad_input for
/// invalid neighbours and for cells that are not positive, environment, and the exceptions of new.
template <int d>
[[nodiscard]] std::vector<double> voronoi_volumes(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                                  Voronoi_counts* counts = nullptr);

/// The number of Voronoi cells that touch the cell of each vertex, which is its number of neighbours in the
/// triangulation; by vertex index below n, 0 where no cell names it. Where d + 2 points are cospherical some cells
/// touch in less than a facet, and the triangulation decides which are counted.
///
/// One pass counts cells: an interior vertex with c cells has c neighbours in 2D and c/2 + 2 in 3D (Euler); a vertex of
/// the hull with b facets in the hull has c + b/2 and (c + b)/2 + 1. O(n); where all points are in a plane or on a
/// line, edges are sorted, O(n log n). Throws unknown_vertex for an index outside [0, n), wrong_size unless each cell
/// has neighbours.
template <int d>
[[nodiscard]] std::vector<Index> voronoi_neighbour_counts(std::size_t n, const Mesh_cells<d>& cells);

extern template std::vector<double> voronoi_volumes<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                       Voronoi_counts*);
extern template std::vector<double> voronoi_volumes<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                       Voronoi_counts*);
extern template std::vector<Index> voronoi_neighbour_counts<2>(std::size_t, const Mesh_cells<2>&);
extern template std::vector<Index> voronoi_neighbour_counts<3>(std::size_t, const Mesh_cells<3>&);

}  // namespace annulus::inline v1
