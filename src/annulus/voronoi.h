// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/types.h>

#include <array>
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

/// The guarantee of voronoi_diagram: the relative error of every finite measure, volume and surface.
inline constexpr double voronoi_diagram_error = 0x1p-32;

/// The guarantee of voronoi_gradient and voronoi_jacobian; see there.
inline constexpr double voronoi_gradient_error = 0x1p-31;

/// The positions x with normal . x <= offset. The normal is not 0; its length does not matter.
template <int d>
struct Half_space {
    Coordinates<d> normal{};
    double offset = 0;
};

/// A convex region to which Voronoi cells are clipped: an axis-aligned box, and the half-spaces that it is intersected
/// with.
template <int d>
struct Voronoi_clip {
    Coordinates<d> lower{}, upper{};  ///< the box; lower[k] < upper[k]
    std::vector<Half_space<d>> half_spaces;
};

/// The region of these half-spaces, with a box a little larger than it. O(m^2) for m of them. Throws not_finite;
/// bad_input unless it is bounded and has an interior. It counts as unbounded if it reaches beyond 2^20 times the
/// largest distance of one of their planes from the origin, or beyond 2^1000; and as without an interior if it is
/// thinner than 2^-50 of its distance from the origin or of its diameter.
template <int d>
[[nodiscard]] Voronoi_clip<d> voronoi_clip(std::span<const Half_space<d>> half_spaces);

/// The Voronoi diagram of a triangulation: cells by vertex index, their common facets by pair of neighbours i < j. In
/// the caller's unit of length, and its powers.
template <int d>
struct Voronoi_diagram {
    /// Pairs of neighbours, that is, the edges of the triangulation, ascending. Each of the following six arrays has an
    /// entry for each pair.
    std::vector<std::array<Index, 2>> pair;
    /// Length (2D) or area (3D) of the facet between the two cells. 0 where it is exactly empty, and only there without
    /// a clip; infinity where it is unbounded.
    std::vector<double> measure;
    std::vector<Coordinates<d>> centroid;  ///< of the facet; NaN where the measure is 0 or infinite
    std::vector<double> distance;          ///< of i and j
    std::vector<Coordinates<d>> vector;    ///< from i to j
    /// 1 where the two cells meet in less than a facet, decided exactly: the triangulation has this edge because d + 2
    /// points or more are cospherical, and another triangulation of them would do without it. It does not depend on a
    /// clip.
    std::vector<char> exactly_empty;
    /// The Voronoi vertices around facet k are ring[ring_begin[k]] to ring[ring_begin[k + 1] - 1], numbers of `vertex`,
    /// counter-clockwise seen from j; two in 2D. The first is -1 where the facet is unbounded, and
    /// then in 3D the others are in the order of the cells from one facet of the hull to the other. A vertex may occur
    /// several times in succession where points are cospherical. No clip changes it.
    std::vector<Index> ring_begin, ring;

    /// The circumcentre of each cell of the triangulation. A cell that has exactly the circumcentre of a neighbour
    /// has the same bits.
    std::vector<Coordinates<d>> vertex;
    /// For each cell the least cell that has the same circumcentre and is connected to it by such cells, decided
    /// exactly.
    std::vector<Index> vertex_of_cell;

    /// The volume of each Voronoi cell, the area in 2D. Infinity where it is unbounded; NaN at free indices.
    std::vector<double> volume;
    std::vector<Coordinates<d>> cell_centroid;  ///< of each Voronoi cell; NaN where it has no finite volume above 0
    std::vector<double> surface;                ///< the area of its boundary, the perimeter in 2D; as volume
};

/// The Voronoi diagram of points in a periodic box, as Periodic_mesh::voronoi makes it: a Voronoi_diagram of which all
/// cells and facets are bounded, and in which an image of a point or of a vertex is its number and a shift. Positions
/// are those of points() and box().
///
/// `pair` has each pair of neighbouring images once: i <= j, the second being points[j] + shift . box, and of a point
/// and an image of its own the greater of the two shifts, ascending by (i, j, shift). `centroid` is that of the facet
/// between the cells of points[i] and of this image; `vector` is exact.
///
/// Corner k of a ring is at vertex[ring[k]] + ring_shift[k] . box, where the first cell of the pair is that around
/// points[i]. Two corners are the same one, exactly, if and only if number and shift are equal. In 2D the cell of i is
/// on the left of the way from the first to the second.
template <int d>
struct Periodic_voronoi_diagram : Voronoi_diagram<d> {
    std::vector<Shift<d>> shift;       ///< by pair: which image of j it is
    std::vector<Shift<d>> ring_shift;  ///< by corner of a ring
    /// The circumcentre of cell c, as Periodic_mesh::cells() has it, is that image of vertex[vertex_of_cell[c]]; vertex
    /// [c] has its coordinates, too. Rings have numbers of cells that are their own vertex_of_cell.
    std::vector<Shift<d>> vertex_shift;
};

/// Computes the Voronoi diagram of a Delaunay triangulation.
///
/// Accuracy without a clip: every finite measure, volume and surface has a relative error of at most
/// voronoi_diagram_error, 2.4e-10 (most have 1e-13), whatever the points; numbers saturate, and underflow, as those of
/// voronoi_volumes. A centroid is off by at most 2^-30 times the largest distance from i to a corner of the facet or
/// cell, and by 2^-52 times the largest coordinate; a vertex by 2^-40 times the shortest edge of its cell, or by 2^-50
/// times its circumradius if that is more, and by 2^-52 times the largest coordinate. Distances and vectors are off by
/// a few units in the last place.
///
/// Method: circumcentres as in voronoi_volumes, in doubles with a bound of their error. Two circumcentres that this
/// does not tell apart are compared exactly. A facet is empty if fewer than d of the facets of the triangulation
/// around its edge join cells of different circumcentres (in the plane of the facet these are the directions of its
/// edges, all different; a closed polygon with an interior has three). A facet that is not empty, and whose bound is
/// too large, is computed from exact circumcentres. Cells are pyramids over their facets with the vertex as apex: no
/// height is negative, so no digits cancel. Results are a function of points and cells, in their order.
///
/// With a clip, cells and facets are intersected with it, so that all are finite. A facet with all its corners inside
/// it is as above, and so are cells that have only such facets. Other cells are cut out of a box in doubles, by the
/// bisectors of their neighbours and by the planes of the clip, each corner once, so that the surface is closed. Let L
/// be the diameter of the box around clip, points and, if there are half-spaces, the origin. A volume is off by 2^-44
/// L^d at most. A measure is off by 2^-46 L^(d-1) / s at most, where s is the sine of the smallest angle between the
/// plane of the facet and that of another side of the cell of i: a facet ends where it meets another side, and where
/// the two nearly coincide, this is far off along both. Two points that are 1e-11 L apart have such cells: some of
/// their measures are off by 1e-5 L^(d-1). A surface is off by as much as its facets are together. These bounds are
/// tested, not proved. The measure of a facet, and the volume of a cell, outside the clip is 0. Coordinates of any
/// magnitude, and normals of any length, have the same errors.
///
/// O(n): about a microsecond per vertex in 2D, 5 in 3D (without a clip), and 20 for a facet that is computed exactly.
/// Preconditions and exceptions as for voronoi_volumes; bad_input where neighbours are not mutual, or have no facet in
/// common; bad_input, not_finite for a clip. Flat sets: every facet is unbounded, and none is found to be empty.
template <int d>
[[nodiscard]] Voronoi_diagram<d> voronoi_diagram(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                                 const Voronoi_clip<d>* clip = nullptr);

/// The gradient of sum_i weights[i] * volume_i: by vertex index its derivatives with respect to the position of the
/// vertex. `weights` has an entry for each point; those of unbounded cells and of free indices count as 0. This is what
/// reverse-mode differentiation calls the vector-Jacobian product of the volumes.
///
/// With A_ij the measure of the facet of i and j and c_ij its centroid, the derivative of volume_i with respect to x_j
/// is A_ij (x_j - c_ij) / |x_i - x_j|, and with respect to x_i minus the sum of these for the volumes of all j. So
/// entry k is the sum of A_kj (w_k - w_j) (c_kj - x_k) / |x_k - x_j| over its neighbours j. Volumes have continuous
/// derivatives as long as no two points meet and the cell is bounded, also where points are cospherical: an empty
/// facet contributes 0, and each triangulation of the points gives the same gradient. Second derivatives jump there.
///
/// Each term is off by at most voronoi_gradient_error times A_kj |w_k - w_j| r / |x_k - x_j|, where r is the largest
/// distance from k to a corner of the facet; the sums are rounded besides. O(n): 0.3 microseconds per vertex in 2D, 3
/// in 3D. Preconditions and exceptions as for voronoi_volumes, and wrong_size.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> voronoi_gradient(std::span<const Coordinates<d>> points,
                                                           const Mesh_cells<d>& cells, std::span<const double> weights);

/// The derivatives of all volumes as a sparse matrix in compressed rows: the derivative of volume_i with respect to the
/// position of vertex index[k] is value[k], for k from begin[i] to begin[i + 1] - 1. Rows of unbounded cells are empty.
/// A row has the vertex itself and its neighbours, ascending; the entries of a row add up to 0.
template <int d>
struct Voronoi_jacobian {
    std::vector<Index> begin, index;
    std::vector<Coordinates<d>> value;
};

/// The terms, costs and errors are those of voronoi_gradient.
template <int d>
[[nodiscard]] Voronoi_jacobian<d> voronoi_jacobian(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells);

template <int d>
class Moving_mesh;

/// The Voronoi diagram of a mesh at its current positions: bit for bit voronoi_diagram of its points and cells; the
/// volume of the only vertex of a mesh is infinite or that of the clip. Throws as above.
///
/// Without a clip the result is kept, 1.5 kB per vertex in 3D (400 bytes in 2D). Later calls compute only the facets
/// around vertices that moves and changes of cells affect, and copy the others: O(n) still, but where one of a hundred
/// vertices moved a quarter of the cost, and where few did a tenth. With a clip everything is computed afresh. Calls
/// for one mesh wait for each other.
[[nodiscard]] Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh);
[[nodiscard]] Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh);
[[nodiscard]] Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh, const Voronoi_clip<2>& clip);
[[nodiscard]] Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh, const Voronoi_clip<3>& clip);

extern template std::vector<double> voronoi_volumes<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                       Voronoi_counts*);
extern template std::vector<double> voronoi_volumes<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                       Voronoi_counts*);
extern template Voronoi_clip<2> voronoi_clip<2>(std::span<const Half_space<2>>);
extern template Voronoi_clip<3> voronoi_clip<3>(std::span<const Half_space<3>>);
extern template Voronoi_diagram<2> voronoi_diagram<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                      const Voronoi_clip<2>*);
extern template Voronoi_diagram<3> voronoi_diagram<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                      const Voronoi_clip<3>*);
extern template std::vector<Coordinates<2>> voronoi_gradient<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                                std::span<const double>);
extern template std::vector<Coordinates<3>> voronoi_gradient<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                                std::span<const double>);
extern template Voronoi_jacobian<2> voronoi_jacobian<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&);
extern template Voronoi_jacobian<3> voronoi_jacobian<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&);
extern template std::vector<Index> voronoi_neighbour_counts<2>(std::size_t, const Mesh_cells<2>&);
extern template std::vector<Index> voronoi_neighbour_counts<3>(std::size_t, const Mesh_cells<3>&);

}  // namespace annulus::inline v1
