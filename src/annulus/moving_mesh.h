// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/error.h>
#include <annulus/options.h>
#include <annulus/types.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

template <int d>
class Delaunay_mesh;
template <int d>
class Moving_mesh;
template <int d>
struct Voronoi_diagram;
[[nodiscard]] Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh);
[[nodiscard]] Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh);

/// A Delaunay triangulation that is kept right while its vertices move, as arrays: Moving_delaunay without an object
/// of CGAL, for callers that need no handles. It has the same engine, options, strategies and errors, and the same
/// guarantees: with Tolerance_kind::certified the cells are proved to be Delaunay at the positions of the vertices
/// after every call. If a call throws, positions and indices are as they were before, except that remove() may have
/// removed the vertex if memory ran out; after a duplicate point, tolerances may have been recomputed and be measured
/// from other fixed positions (for GMP and CGAL's Mpzf see internal/moving_delaunay.h). Every call that may change the
/// mesh can throw std::bad_alloc, and too_large: the mesh would have, or had in between, more cells or vertices than
/// indices can name (limits.h). Error::vertices() has all vertices concerned.
///
/// Positions are in the caller's unit of length. Not thread-safe; const members may run concurrently. Preconditions of
/// every call: arithmetic in IEEE doubles, rounding to nearest. Construction, copying, find_cell, find_cells,
/// voronoi_volumes and voronoi_gradient check this and throw environment; moves, insert and remove do not.
///
/// Vertices have indices in input order. Removing a vertex makes its index free; the next insertion takes the index
/// that was freed last.
template <int d>
class Moving_mesh {
  public:
    static constexpr int dimension_of_space = d;
    using Point = Coordinates<d>;

    explicit Moving_mesh(const Options& options = {}) : Moving_mesh(std::span<const Point>{}, options) {}
    /// O(n log n). Throws not_finite, out_of_domain, duplicate_point (unless options.merge_duplicates), too_large,
    /// environment.
    explicit Moving_mesh(std::span<const Point> points, const Options& options = {});
    /// The same from d numbers per point. Also throws wrong_size if the number of coordinates is no multiple of d.
    explicit Moving_mesh(std::span<const double> coordinates, const Options& options = {});
    ~Moving_mesh();
    /// A moved-from object can only be destroyed or assigned to. O(1).
    Moving_mesh(Moving_mesh&&) noexcept;
    Moving_mesh& operator=(Moving_mesh&&) noexcept;
    /// A copy with the same indices, free ones included, and options. It is built from the positions, so that it has
    /// the same cells under other numbers, and recomputes its tolerances. O(n log n). Throws environment,
    /// duplicate_point where tolerances that are not certified have let two positions coincide. Precondition: not a
    /// moved-from object.
    Moving_mesh(const Moving_mesh&);
    Moving_mesh& operator=(const Moving_mesh&);

    /// Moves one vertex. Expected O(degree) for a short way. Throws unknown_vertex, not_finite, out_of_domain,
    /// duplicate_point.
    Move_result move(Index i, const Point& p);
    /// Moves some vertices: indices[k] to points[k], all at once (a vertex may go where another one was). If an index
    /// is named twice, its last point counts. Under a strategy that repairs the mesh, at most one vertex in 64 costs
    /// as much as single moves; otherwise the call costs as much as move_all. Throws wrong_size unless there is
    /// one point for each index, and what the move of one vertex throws.
    Move_result move(std::span<const Index> indices, std::span<const Point> points);
    /// Moves every vertex: points[i] is the new position of vertex i; points at free indices are ignored. O(n) with a
    /// small constant when few tolerances fail. Throws wrong_size unless there are index_bound() points, not_finite,
    /// out_of_domain, duplicate_point.
    Move_result move_all(std::span<const Point> points);
    /// Inserts a vertex and returns its index: the one that was freed last, or index_bound(). Expected O(log n +
    /// degree), and O(n) for the first insertion after a construction, which copies arrays, and while all points are in
    /// a plane or on a line. Throws not_finite, out_of_domain, duplicate_point (Error::vertices() has the vertex at p),
    /// and too_large, also if all indices are in use.
    Index insert(const Point& p, Move_result* report = nullptr);
    /// Removes a vertex; its index becomes free. Expected O(degree). Throws unknown_vertex. If memory runs out the
    /// vertex may have been removed: see is_vertex(i).
    void remove(Index i, Move_result* report = nullptr);
    /// Makes the moving position of every vertex its fixed one and computes every tolerance again. O(n).
    Move_result recompute_tolerances();

    [[nodiscard]] std::size_t number_of_vertices() const;
    /// Affine dimension of the points, -1 if there are none.
    [[nodiscard]] int dimension() const;
    /// One more than the largest index in use or free: the number of points that move_all takes.
    [[nodiscard]] std::size_t index_bound() const;
    /// Whether a vertex has this index.
    [[nodiscard]] bool is_vertex(Index i) const;
    /// Vertex index of every input point: 0, 1, 2, ... unless duplicate points were merged. Valid as long as this
    /// object, also if it is moved, and until it is assigned to; removals and insertions do not change it.
    [[nodiscard]] std::span<const Index> vertex_of_input() const;

    /// Positions by index, NaN at free indices. Valid until the next call of a member that is not const: such a call
    /// may write to the array or replace it. It may be an argument of that call.
    [[nodiscard]] std::span<const Point> points() const;
    /// The positions at which the cells are Delaunay. They differ from points() only while tolerances that are not
    /// certified are kept. Valid as long as points().
    [[nodiscard]] std::span<const Point> delaunay_positions() const;
    /// Every finite cell. O(n).
    [[nodiscard]] Mesh_cells<d> cells() const;

    // Lists, which are made on request and kept until a cell changes: 24 (2D) or 32 (3D) bytes per cell and 4 per
    // vertex for the cells, about 28 (2D) or 66 (3D) per vertex for neighbours. After a change the first call is O(n).
    // While all vertices are in a plane or on a line, every call that may change the mesh counts as a change. A list
    // that is shared is never changed.

    /// The same as cells(), with a cell of each vertex.
    [[nodiscard]] std::shared_ptr<const Cell_lists<d>> cell_lists() const;
    /// The vertices that an edge joins to vertex i, in ascending order. Valid until the next call of a member that is
    /// not const. Throws unknown_vertex.
    [[nodiscard]] std::span<const Index> neighbors(Index i) const;
    /// Those of all vertices; none at free indices.
    [[nodiscard]] std::shared_ptr<const Vertex_neighbours> vertex_neighbors() const;
    /// The vertices of the facets of the convex hull: in 2D edges with the triangulation on their left, in 3D triangles
    /// that are counter-clockwise seen from outside. Empty if the vertices do not span d dimensions.
    [[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d)>> convex_hull() const;
    /// The number, in cells(), of a cell that contains p in its interior or on its border; -1 if p is outside the
    /// convex hull or has a coordinate that is not a number, and if the vertices do not span d dimensions. Exact: found
    /// by a walk whose every turn is decided by an exact sign. For a point on a facet it is any cell of that facet.
    /// Expected O(cbrt(n)), with a list of cells that is kept. Throws environment.
    [[nodiscard]] Index find_cell(const Point& p) const;
    /// The same for several points. A walk begins where the last one ended if nothing better is found, so points in an
    /// order in which neighbours follow each other are found faster.
    [[nodiscard]] std::vector<Index> find_cells(std::span<const Point> points) const;
    /// By vertex index: how far the vertex may be from its fixed position while every other vertex is within its own
    /// tolerance of its own fixed position; a certified lower bound with Tolerance_kind::certified. While no tolerances
    /// are kept, the least tolerance of its certificates. 0 if all points are in a plane or on a line, NaN at free
    /// indices. O(n).
    [[nodiscard]] std::vector<double> tolerances() const;
    [[nodiscard]] double tolerance(Index i) const;
    /// The position from which the displacement D is measured, and an upper bound of D = |position - fixed position|.
    /// These and theta() throw unknown_vertex.
    [[nodiscard]] Point fixed_position(Index i) const;
    [[nodiscard]] double displacement(Index i) const;
    /// Least theta of the finite bi-cells of a vertex, in radians; pi/2 if it has none.
    [[nodiscard]] double theta(Index i) const;
    /// Tolerances, annulus widths and theta, computed for the current positions with any strategy. O(n).
    [[nodiscard]] Measures measure() const;

    /// The areas or volumes of the Voronoi cells by vertex index: bit for bit what voronoi_volumes
    /// (voronoi.h) returns for points() and cells(), and infinity for a single vertex. The results
    /// are kept from the first call on, about 350 bytes per vertex in 3D (130 in 2D). Later calls compute only the
    /// volumes that are affected by moves and changes of cells since then, and compare one position per vertex.
    /// Throws bad_input if tolerances that are not certified have left a cell that is not positive, environment, and
    /// what new throws.
    [[nodiscard]] std::vector<double> voronoi_volumes() const;
    /// The gradient of sum_i weights[i] * volume_i: what voronoi_gradient (voronoi.h) returns for points() and cells(),
    /// up to the order of sums. In 2D it uses what is kept for the volumes. Throws as above, and wrong_size.
    [[nodiscard]] std::vector<Point> voronoi_gradient(std::span<const double> weights) const;

    /// Exact audit at the current positions; see audit.h. O(n).
    [[nodiscard]] Audit_result audit() const { return annulus::audit(audit_input()); }
    [[nodiscard]] Audit_input<d> audit_input() const;

    /// The mesh that the strategies change. Not part of the stable interface.
    [[nodiscard]] const Delaunay_mesh<d>& mesh() const;

    [[nodiscard]] const Options& options() const;
    /// The strategy in use: that of the options, except that `paper-hybrid` becomes `paper` when it switches.
    [[nodiscard]] Strategy strategy() const;

  private:
    template <int>
    friend class Mesh_access;  // CGAL's view (internal/mesh_access.h)
    friend Voronoi_diagram<2> voronoi(const Moving_mesh<2>& mesh);
    friend Voronoi_diagram<3> voronoi(const Moving_mesh<3>& mesh);
    struct Parts;
    [[nodiscard]] Delaunay_mesh<d>& changeable_mesh();
    [[nodiscard]] Voronoi_diagram<d> voronoi_diagram() const;

    std::unique_ptr<Parts> parts_;
};

extern template class Moving_mesh<2>;
extern template class Moving_mesh<3>;

using Moving_mesh_2 = Moving_mesh<2>;
using Moving_mesh_3 = Moving_mesh<3>;

}  // namespace annulus::inline v1
