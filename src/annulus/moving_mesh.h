// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/error.h>
#include <annulus/engine/move_report.h>
#include <annulus/engine/options.h>
#include <annulus/mesh/audit.h>
#include <annulus/mesh/measures.h>
#include <annulus/mesh/mesh_cells.h>

#include <memory>
#include <span>
#include <vector>

namespace annulus {

template <int d>
class Delaunay_mesh;

/// A Delaunay triangulation that is kept right while its vertices move, as arrays: Moving_delaunay without an object
/// of CGAL's, for callers that need no handles. The same engine, options, strategies and errors, and the same promises:
/// with Tolerance_kind::certified the cells are Delaunay at the positions of the vertices after every call, proved;
/// positions and indices are as they were when a call throws (but that remove() may have removed the vertex when
/// memory ran out; as to GMP and CGAL's Mpzf see moving_delaunay.h). Positions are in the caller's unit of length.
/// Not thread-safe; const members may run concurrently.
///
/// Vertices have an index in input order. Removing a vertex leaves its index free; the next insertion takes the
/// index freed last.
template <int d>
class Moving_mesh {
  public:
    static constexpr int dimension_of_space = d;
    using Point = Coordinates<d>;

    explicit Moving_mesh(const Options& options = {}) : Moving_mesh(std::span<const Point>{}, options) {}
    /// O(n log n). Throws not_finite, out_of_domain, duplicate_point (unless options.merge_duplicates), too_large,
    /// environment.
    explicit Moving_mesh(std::span<const Point> points, const Options& options = {});
    /// The same from d numbers a point. Throws wrong_size too, when a number is missing.
    explicit Moving_mesh(std::span<const double> coordinates, const Options& options = {});
    ~Moving_mesh();
    /// One that was moved from can be destroyed and assigned to, nothing else. O(1).
    Moving_mesh(Moving_mesh&&) noexcept;
    Moving_mesh& operator=(Moving_mesh&&) noexcept;

    /// As in Moving_delaunay.
    Move_report move(Index i, const Point& p);
    Move_report move(std::span<const Index> indices, std::span<const Point> points);
    Move_report move_all(std::span<const Point> points);
    /// Inserts a vertex and returns its index. Throws not_finite, out_of_domain, duplicate_point.
    Index insert(const Point& p, Move_report* report = nullptr);
    /// Throws unknown_vertex.
    void remove(Index i, Move_report* report = nullptr);
    /// Makes every fixed position the moving one and every tolerance fresh. O(n).
    Move_report recompute_tolerances();

    [[nodiscard]] std::size_t number_of_vertices() const;
    /// Affine dimension of the points, -1 when there are none.
    [[nodiscard]] int dimension() const;
    /// One more than the largest index in use or free: the number of points move_all takes.
    [[nodiscard]] std::size_t index_bound() const;
    /// Whether this index is a vertex'.
    [[nodiscard]] bool is_vertex(Index i) const;
    /// Vertex index of every input point; differs from 0, 1, 2 ... only where duplicates were merged.
    [[nodiscard]] std::span<const Index> vertex_of_input() const;

    /// Positions by index; free entries are unspecified.
    [[nodiscard]] std::span<const Point> points() const;
    /// Every finite cell. O(n).
    [[nodiscard]] Mesh_cells<d> cells() const;
    /// By vertex index: how far it may be from its fixed position while every other vertex is within its own
    /// tolerance of its own; a certified lower bound with Tolerance_kind::certified. While no tolerances are kept,
    /// the least tolerance of its certificates. 0 at free indices and where all points are in a plane or on a line.
    /// O(n).
    [[nodiscard]] std::vector<double> tolerances() const;
    [[nodiscard]] double tolerance(Index i) const;
    /// Where D is measured from, and an upper bound of |position - fixed position|. Throws unknown_vertex, here and
    /// below.
    [[nodiscard]] Point fixed_position(Index i) const;
    [[nodiscard]] double displacement(Index i) const;
    /// Least theta of the finite bi-cells of a vertex in radians; pi/2 when it has none.
    [[nodiscard]] double theta(Index i) const;
    /// Fresh tolerances, annulus widths and theta of everything, whatever the strategy. O(n).
    [[nodiscard]] Measures measure() const;

    /// The areas or volumes of the Voronoi cells by vertex index: bit for bit what voronoi_volumes
    /// (statistics/voronoi_volumes.h) gives for points() and cells(), and infinity for a vertex that is alone. What
    /// it computed is kept, in 3D some 350 bytes a vertex (130 in 2D), from the first call on; later ones
    /// compute what moves and changes of cells since then concern, and compare one position a vertex besides.
    /// Throws bad_input where tolerances that are not certified have left a cell that is not positive, environment,
    /// and what new throws.
    [[nodiscard]] std::vector<double> voronoi_volumes() const;

    /// Exact verdict at the present positions; see audit.h. O(n).
    [[nodiscard]] Audit_result audit() const { return annulus::audit(audit_input()); }
    [[nodiscard]] Audit_input<d> audit_input() const;

    /// What the strategies work on. Not a part of the stable interface.
    [[nodiscard]] const Delaunay_mesh<d>& mesh() const;

    [[nodiscard]] const Options& options() const;
    /// The strategy in force: that of the options, except that `paper-hybrid` becomes `paper` when it switches.
    [[nodiscard]] Strategy strategy() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

extern template class Moving_mesh<2>;
extern template class Moving_mesh<3>;

using Moving_mesh_2 = Moving_mesh<2>;
using Moving_mesh_3 = Moving_mesh<3>;

}  // namespace annulus
