// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/box.h>
#include <annulus/error.h>
#include <annulus/types.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// What a caller can choose of a periodic mesh.
struct Periodic_options {
    int threads = 1;  ///< of a build: 1 or more, else Error(usage); the triangulation does not depend on it
};

/// What a periodic mesh is made of, exactly: a mesh made of it is the same, bit for bit, wherever its points are.
template <int d>
struct Saved_periodic_mesh {
    typename Box<d>::Vectors vectors;    ///< of the box as it was given, not rounded
    std::vector<Coordinates<d>> places;  ///< Periodic_mesh::places
    std::vector<Shift<d>> images;        ///< Periodic_mesh::images, as many
};

/// The Delaunay triangulation of points in a periodic box, which moves with them: of all their translates by the
/// vectors of the box, as finitely many cells with offsets. Any number of points from none on, in any box (box.h):
/// there is no least number, and no copies of the box in the result. It is exact, and proved after every build: the
/// Delaunay triangulation of points() and box(), which are the caller's, rounded once (docs/periodic.md says how). In
/// cospherical cases it is the one of the perturbation that Moving_mesh uses, which is the same for every image.
///
/// A move tests all signs and flips where one fails, O(n) and more for each flip; where flips are stuck or would cost
/// more it rebuilds, O(n log n). The triangulation is the same, numbers of cells may differ. There are no
/// tolerances, no insertion and no removal yet. A call that throws leaves the object as it was. Not thread-safe; const
/// members may run concurrently.
template <int d>
class Periodic_mesh {
  public:
    static constexpr int dimension_of_space = d;
    using Point = Coordinates<d>;

    /// Points may be anywhere: any image of each. Throws not_finite; out_of_domain for a point more than 2^29 boxes
    /// away; duplicate_point, naming two points that are, rounded, images of one another; too_large; usage;
    /// environment; and what new throws.
    Periodic_mesh(std::span<const Point> points, const Box<d>& box, const Periodic_options& options = {});
    /// The mesh that was saved. Throws bad_input where a place is not on the grid of the box or not in it, an image is
    /// more than 2^29 boxes away, or there are not as many images as places; and what the other constructor throws.
    explicit Periodic_mesh(const Saved_periodic_mesh<d>& saved, const Periodic_options& options = {});
    ~Periodic_mesh();
    /// A moved-from object can only be destroyed or assigned to. O(1).
    Periodic_mesh(Periodic_mesh&&) noexcept;
    Periodic_mesh& operator=(Periodic_mesh&&) noexcept;

    /// Moves all points, in the order of their indices; any image of each. The box is the same, as it was given, not
    /// rounded. In the result all are `rebuilt`, or those are `flipped` that are in cells made by flips, and the others
    /// `kept_in_place`; it lists no cells, and its cost is that of flips and of a build. Throws what the constructor
    /// throws, and wrong_size unless there are as many as before.
    Move_result move_all(std::span<const Point> points);
    /// The same in another box: of any shape, in another basis of the same lattice, too.
    Move_result move_all(std::span<const Point> points, const Box<d>& box);

    [[nodiscard]] std::size_t number_of_vertices() const;
    /// The box with its vectors rounded to the grid.
    [[nodiscard]] const Box<d>& box() const;
    /// The images of the points that the caller gave, rounded to the grid; the nearest doubles to these where a point
    /// is more than eight boxes away from the origin (of the reduced box, where the box is skewed). Valid until the
    /// next call of move_all, as all spans here.
    [[nodiscard]] std::span<const Point> points() const;
    /// The representatives of the points near the origin's box: exact, wherever the points are. Valid as long as
    /// points().
    [[nodiscard]] std::span<const Point> places() const;
    /// Which image each point is of its representative: points()[i] is at places()[i] + images()[i] . box().
    /// Valid as long as points().
    [[nodiscard]] std::span<const Shift<d>> images() const;
    /// The spacing of the grid on each axis.
    [[nodiscard]] Point grid() const;

    /// The number of cells: 2n in 2D; in 3D the number of edges less n.
    [[nodiscard]] std::size_t number_of_cells() const;
    /// The cells, with offsets that refer to points(). O(n).
    [[nodiscard]] Periodic_cells<d> cells() const;
    /// Every pair of Voronoi cells that the triangulation makes neighbours, with the measure of their common facet.
    /// O(n), a few microseconds a point.
    [[nodiscard]] Periodic_neighbours<d> neighbours() const;
    /// By point: how many neighbours have a facet of more than this area in common with it; with `strict` false, of at
    /// least this area. With the defaults facets that are exactly empty are not counted, and all others are. A point
    /// that is its own neighbour counts twice, once for each side. O(n). Throws not_finite for an area that is NaN.
    [[nodiscard]] std::vector<Index> neighbour_counts(double least_area = 0, bool strict = true) const;
    /// The areas or volumes of the Voronoi cells, with a relative error of 2^-33 at most. They add up to the box's.
    /// O(n).
    [[nodiscard]] std::vector<double> voronoi_volumes() const;

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
