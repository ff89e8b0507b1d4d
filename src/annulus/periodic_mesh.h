// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/box.h>
#include <annulus/error.h>
#include <annulus/options.h>
#include <annulus/types.h>
#include <annulus/voronoi.h>

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// What a caller can choose of a periodic mesh.
struct Periodic_options {
    int threads = 1;              ///< 1 or more, else Error(usage); results do not depend on it
    bool report_changes = false;  ///< whether calls list the pairs and cells that they change (Periodic_mesh::changes)
    Periodic_strategy strategy = Periodic_strategy::automatic;  ///< of moves; the triangulation does not depend on it
    /// Of the constructor from points: those that are, rounded to the grid, images of one another are one vertex. An
    /// image whose coordinates were computed in doubles may be rounded to the next place, and is another vertex then.
    bool merge_duplicates = false;
};

/// Pairs of neighbouring images: point second[k], moved by shift[k] . box, and point first[k]. Each pair once: first <=
/// second, and of a point and an image of its own the greater of the two shifts. Ascending by (first, second, shift).
template <int d>
struct Periodic_pairs {
    std::vector<Index> first, second;
    std::vector<Shift<d>> shift;
};
/// Cells, positively oriented: corner k of cell c is at points[vertices[c][k]] + offsets[c][k] . box. Each is written
/// in one way only, so that lists can be compared: its corners ascend by (vertex, offset), the last two exchanged where
/// that makes the cell positive, and its least offset is 0 in each direction. Ascending.
template <int d>
struct Periodic_cell_list {
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> vertices;
    std::vector<std::array<Shift<d>, static_cast<std::size_t>(d + 1)>> offsets;
};
/// What a call changed. Facets of the triangulation count, also those that are exactly empty (Periodic_neighbours). A
/// cell that was turned over is in both lists of cells.
template <int d>
struct Periodic_changes {
    Periodic_pairs<d> made;         ///< pairs that are new; shifts are between points() and by box() after the call
    Periodic_pairs<d> broken;       ///< pairs that are no longer there, by points and box before it
    Periodic_cell_list<d> changed;  ///< cells that are new, by points and box after the call
    Periodic_cell_list<d> gone;     ///< cells that are no longer there, by points and box before it
};

/// What a periodic mesh is made of, exactly: a mesh made of it is the same, bit for bit, wherever its points are.
template <int d>
struct Saved_periodic_mesh {
    typename Box<d>::Vectors vectors;    ///< of the box as it was given, not rounded
    std::vector<Coordinates<d>> places;  ///< Periodic_mesh::places
    std::vector<Shift<d>> images;        ///< Periodic_mesh::images, as many
    std::vector<Index> free_indices{};   ///< of no vertex, what is there is not read; the next one to be used last
};

/// The Delaunay triangulation of points in a periodic box, which moves with them: of all their translates by the
/// vectors of the box, as finitely many cells with offsets. Any number of points from none on, in any box (box.h):
/// there is no least number, and no copies of the box in the result. It is exact, and proved after every build: the
/// Delaunay triangulation of points() and box(), which are the caller's, rounded once (docs/periodic.md says how). In
/// cospherical cases it is the one of the perturbation that Moving_mesh uses, which is the same for every image.
///
/// A move tests all signs, or with tolerances (Periodic_options::strategy) the certificates of points that have left
/// theirs, and flips where one fails, O(n) and more for each flip; where flips are stuck or would cost more it
/// rebuilds, O(n log n). The triangulation is the same, numbers of cells may differ. A call that throws leaves the
/// object as it was, but that no tolerances may be kept for the next move. Not thread-safe; const members may run
/// concurrently.
///
/// Tolerances are those of ways relative to the box: points that follow a box that is strained in all directions alike,
/// or turned, keep theirs; where its shape changes they lose as much as a certificate is deformed (docs/theory.md 8.9).
///
/// Vertices have indices in input order. Removing a vertex makes its index free; the next insertion takes the index
/// that was freed last.
template <int d>
class Periodic_mesh {
  public:
    static constexpr int dimension_of_space = d;
    using Point = Coordinates<d>;

    /// Points may be anywhere: any image of each. Throws not_finite; out_of_domain for a point more than 2^29 boxes
    /// away; duplicate_point (unless options.merge_duplicates), naming all points that are, rounded, images of one, the
    /// lowest two of all that coincide among them; too_large; usage; environment; and what new throws.
    Periodic_mesh(std::span<const Point> points, const Box<d>& box, const Periodic_options& options = {});
    /// The mesh that was saved. Throws bad_input where a place is not on the grid of the box or not in it, an image is
    /// more than 2^29 boxes away, or there are not as many images as places; and what the other constructor throws.
    explicit Periodic_mesh(const Saved_periodic_mesh<d>& saved, const Periodic_options& options = {});
    ~Periodic_mesh();
    /// A moved-from object can only be destroyed or assigned to. O(1).
    Periodic_mesh(Periodic_mesh&&) noexcept;
    Periodic_mesh& operator=(Periodic_mesh&&) noexcept;

    /// Moves all points, in the order of their indices; any image of each. There are index_bound() of them; those at
    /// free indices are not read. The box is the same, as it was given, not rounded. In the result all are `rebuilt`,
    /// or those are `flipped` that are in cells made by flips, and the others `kept_in_place`, or `within_tolerance` in
    /// a move that began with tolerances; it lists no cells, and its cost is that of certificates, flips and a build.
    /// Throws what the constructor throws, and wrong_size.
    Move_result move_all(std::span<const Point> points);
    /// The same in another box: of any shape, in another basis of the same lattice, too.
    Move_result move_all(std::span<const Point> points, const Box<d>& box);

    /// Moves one vertex: move(indices, points) of one, which is reinserted wherever that is possible, whatever it costs
    /// to move all.
    Move_result move(Index i, const Point& p);
    /// Moves some vertices: indices[k] to any image of points[k], all at once (a vertex may go where another one was).
    /// If an index is named twice, its last point counts. They are removed, and inserted where they go, which costs
    /// what these cost, each; the result counts those that are named, as `reinserted`, or `kept_in_place` if only their
    /// image is another one. Where move_all is expected to cost less, by counts, or where that is not possible, with
    /// few points or in a thin box, the call is move_all, and its result as there. Throws wrong_size unless there is
    /// one point for each index, unknown_vertex, not_finite, out_of_domain, duplicate_point, too_large, bad_alloc,
    /// environment.
    Move_result move(std::span<const Index> indices, std::span<const Point> points);

    /// Evaluates every certificate, and keeps tolerances from now on, those of the present places, until they do not
    /// pay (Periodic_strategy::automatic). With Periodic_strategy::signs, and without vertices, it does nothing. O(n).
    /// Throws bad_alloc, without tolerances, and environment.
    Move_result recompute_tolerances();

    /// Inserts a vertex, any image of it, and returns its index: the one that was freed last, or index_bound().
    /// Replaces cells near it, expected O(n^(1/3) + degree); with few points, or in a box that is thinner than cells
    /// are long, it builds (docs/periodic.md). Throws duplicate_point, naming the vertex that has, rounded, an image at
    /// this place, and what the constructor throws; an error that concerns the point names it 0.
    Index insert(const Point& p);
    /// The same for several points, all or none: their indices, first free ones. O(n) and what was said for each; more
    /// than an eighth of all points are built with the others at once. Points that are images of one another are an
    /// error without vertices, not_finite and out_of_domain name points of the argument.
    std::vector<Index> insert(std::span<const Point> points);
    /// Removes a vertex; its index becomes free. Costs what insert costs. Throws unknown_vertex, bad_alloc,
    /// environment, and too_large where it has to build.
    void remove(Index i);
    /// The same for several vertices, all or none. An index that occurs twice is unknown_vertex, too.
    void remove(std::span<const Index> indices);

    /// The vertex of each point that the constructor was given, of a saved mesh of each index: 0, 1, 2, .. unless
    /// duplicate points were merged. Valid as long as the mesh.
    [[nodiscard]] std::span<const Index> vertex_of_input() const;

    [[nodiscard]] std::size_t number_of_vertices() const;
    /// One more than the largest index in use or free: the number of points that move_all takes.
    [[nodiscard]] std::size_t index_bound() const;
    /// Whether a vertex has this index.
    [[nodiscard]] bool is_vertex(Index i) const;
    /// The box with its vectors rounded to the grid.
    [[nodiscard]] const Box<d>& box() const;
    /// The images of the points that the caller gave, rounded to the grid; the nearest doubles to these where a point
    /// is more than eight boxes away from the origin (of the reduced box, where the box is skewed). NaN at free
    /// indices. Valid until the next call of a member that is not const, as all spans here; may be an argument of it.
    [[nodiscard]] std::span<const Point> points() const;
    /// The representatives of the points near the origin's box: exact, wherever the points are. NaN at free indices.
    /// Valid as long as points().
    [[nodiscard]] std::span<const Point> places() const;
    /// Which image each point is of its representative: points()[i] is at places()[i] + images()[i] . box().
    /// 0 at free indices. Valid as long as points().
    [[nodiscard]] std::span<const Shift<d>> images() const;
    /// The spacing of the grid on each axis.
    [[nodiscard]] Point grid() const;

    /// The number of cells: 2n in 2D; in 3D the number of edges less n.
    [[nodiscard]] std::size_t number_of_cells() const;
    /// The cells, with offsets that refer to points(). O(n).
    [[nodiscard]] Periodic_cells<d> cells() const;
    /// The cell that contains p, in its interior or on its border: decided exactly, for p as it would be rounded if it
    /// were inserted. -1 where there are no cells and for a coordinate that is NaN. Expected O(n^(1/(d + 1))), by a
    /// walk; in a box that is much longer than wide O(n). Throws out_of_domain, naming p 0, and environment.
    [[nodiscard]] Periodic_location<d> find_cell(const Point& p) const;
    /// The same for several points; errors name the point. Infinity is not_finite.
    [[nodiscard]] std::vector<Periodic_location<d>> find_cells(std::span<const Point> points) const;
    /// The image of a vertex that is nearest to p, beside p, wherever p is; of several, any of them. Decided exactly,
    /// for p as it would be rounded if it were inserted. None where there are no vertices, and for a coordinate that is
    /// NaN. Costs what find_cell costs, and throws what it throws.
    [[nodiscard]] Periodic_image<d> nearest_vertex(const Point& p) const;
    /// The same for several points; errors name the point.
    [[nodiscard]] std::vector<Periodic_image<d>> nearest_vertices(std::span<const Point> points) const;
    /// The natural neighbours of some points, beside them, with Laplace's weights: the facet that the Voronoi cells of
    /// p and of the image would have in common if p were inserted, over their distance, divided by the sum of these. So
    /// they interpolate values at vertices. All images of p are inserted with it; where its cell has facets in common
    /// with them, with few vertices, these do not count: weights add up to 1, and the weighted sum of the vectors to
    /// the images is 0, both up to rounding. At a vertex its own weight is 1. No images for a coordinate that is NaN,
    /// and where there are no vertices. Some ten microseconds for each point in 2D, two hundred in 3D, more in thin
    /// boxes. Throws what find_cells throws.
    [[nodiscard]] Periodic_weights<d> natural_neighbours(std::span<const Point> points) const;
    /// Every pair of Voronoi cells that the triangulation makes neighbours, with the measure of their common facet.
    /// O(n), a few microseconds a point.
    [[nodiscard]] Periodic_neighbours<d> neighbours() const;
    /// By point: how many neighbours have a facet of more than this area in common with it; with `strict` false, of at
    /// least this area. With the defaults facets that are exactly empty are not counted, and all others are. A point
    /// that is its own neighbour counts twice, once for each side. 0 at free indices. O(n). Throws not_finite for NaN.
    [[nodiscard]] std::vector<Index> neighbour_counts(double least_area = 0, bool strict = true) const;
    /// The areas or volumes of the Voronoi cells, with a relative error of 2^-33 at most. They add up to the box's. NaN
    /// at free indices. O(n).
    [[nodiscard]] std::vector<double> voronoi_volumes() const;
    /// The Voronoi diagram: facets with corners, measures and centroids; volumes and centroids of cells. Measures,
    /// volumes and surfaces have a relative error of voronoi_diagram_error at most; centroids and vertices the errors
    /// that voronoi_diagram promises without a clip. O(n), some microseconds a point, 20 for a facet that is computed
    /// exactly. Throws environment, and what new throws.
    [[nodiscard]] Periodic_voronoi_diagram<d> voronoi() const;
    /// The gradient of sum_i weights[i] * volume_i, and the derivatives of all volumes: voronoi_gradient and
    /// voronoi_jacobian (voronoi.h), with their errors, in a box that keeps its vectors. All images of a point move
    /// with it, and a row of the matrix has one entry for all images of a neighbour. O(n). The first throws wrong_size.
    [[nodiscard]] std::vector<Point> voronoi_gradient(std::span<const double> weights) const;
    [[nodiscard]] Voronoi_jacobian<d> voronoi_jacobian() const;

    /// By point: a lower bound of how far it may be from its place (places()) while every other point is as near to its
    /// own, or nearer, by its own bound, and the box stays: no cell changes. NaN at free indices. While tolerances are
    /// kept these are what is left of them, O(n); otherwise all certificates are evaluated, O(n), in 3D a few
    /// microseconds a point. Insertions and removals end them, and with `auto` so do moves for which they do not pay;
    /// then the next move that allows it begins them again. Throws bad_alloc and environment.
    [[nodiscard]] std::vector<double> tolerances() const;

    /// By point: the least theta (predicates.h) of the bi-cells of its images, in radians; NaN at free indices. It is
    /// small where two neighbouring cells have nearly the same circumscribed circle or sphere. O(n).
    [[nodiscard]] std::vector<double> thetas() const;

    /// With options().report_changes: what the last call that moves, inserts or removes changed; nothing before the
    /// first one. Points that are given as other images change nothing, nor does a box in another basis of its lattice:
    /// a pair stays where each point moves to the image nearest to where the affine map of the boxes takes it. (Where a
    /// box changes by half and more, so that no unimodular matrix relates the two, every pair is broken, and made, and
    /// so are cells.) Such a call copies arrays, O(n), and sorts the edges of cells that have changed. Valid as long as
    /// points().
    [[nodiscard]] const Periodic_changes<d>& changes() const;

    /// Exact audit of the cells, for places() and box(); see audit.h. O(n).
    [[nodiscard]] Audit_result audit() const { return annulus::audit(audit_input()); }
    /// Its input: places(), the vectors of box(), and cells() with offsets that refer to places().
    [[nodiscard]] Periodic_audit_input<d> audit_input() const;

    [[nodiscard]] const Periodic_options& options() const;
    /// What makes the same mesh again. O(n).
    [[nodiscard]] Saved_periodic_mesh<d> saved() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

extern template class Periodic_mesh<2>;
extern template class Periodic_mesh<3>;

using Periodic_mesh_2 = Periodic_mesh<2>;
using Periodic_mesh_3 = Periodic_mesh<3>;

}  // namespace annulus::inline v1
