// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A Moving_delaunay with the members of Moving_mesh, so that a test can run through both classes, and a file that only
// needs CGAL's triangulation beside the engine is compiled without CGAL. Tests of handles use Moving_delaunay itself.

#include <annulus/audit.h>
#include <annulus/error.h>
#include <annulus/options.h>
#include <annulus/types.h>
#include <common/cells.h>

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

template <int d>
class Delaunay_mesh;

}  // namespace annulus::inline v1

namespace annulus::testing {

/// A finite bi-cell: its facet, and the two vertices on either side. In 2D the edge a b, p right of it and q left.
template <int d>
using Bicell_indices = std::array<Index, static_cast<std::size_t>(d + 2)>;

/// The object of the library; see viewed.h.
template <int d>
struct Viewed;

/// Every member makes the call of Moving_delaunay with the same name: those of a vertex through the handle of its
/// index, audit() with CGAL's object. The errors are its errors.
template <int d>
class Viewed_mesh {
  public:
    static constexpr int dimension_of_space = d;
    using Point = Coordinates<d>;

    explicit Viewed_mesh(const Options& options = {});
    explicit Viewed_mesh(std::span<const Point> points, const Options& options = {});
    explicit Viewed_mesh(std::unique_ptr<Viewed<d>> viewed);
    ~Viewed_mesh();
    Viewed_mesh(Viewed_mesh&&) noexcept;
    Viewed_mesh& operator=(Viewed_mesh&&) noexcept;

    /// By index, without the handle.
    Move_result move(Index i, const Point& p);
    Move_result move(std::span<const Index> indices, std::span<const Point> points);
    Move_result move_all(std::span<const Point> points);
    Index insert(const Point& p, Move_result* report = nullptr);
    void remove(Index i, Move_result* report = nullptr);
    Move_result recompute_tolerances();

    [[nodiscard]] std::size_t number_of_vertices() const;
    [[nodiscard]] std::size_t index_bound() const;
    /// Whether the index has a handle.
    [[nodiscard]] bool is_vertex(Index i) const;
    [[nodiscard]] std::span<const Index> vertex_of_input() const;
    [[nodiscard]] std::span<const Point> points() const;
    [[nodiscard]] Mesh_cells<d> cells() const;
    [[nodiscard]] double tolerance(Index i) const;
    [[nodiscard]] Point fixed_position(Index i) const;
    [[nodiscard]] double displacement(Index i) const;
    [[nodiscard]] double theta(Index i) const;
    [[nodiscard]] Measures measure() const;
    [[nodiscard]] Audit_result audit() const;
    [[nodiscard]] Audit_input<d> audit_input() const;
    [[nodiscard]] const Delaunay_mesh<d>& mesh() const;
    [[nodiscard]] const Options& options() const;
    [[nodiscard]] Strategy strategy() const;

    // ---- CGAL's object --------------------------------------------------------------------------------------------
    /// Its finite cells.
    [[nodiscard]] oracle::Cells_of<d> view_cells() const;
    /// Its finite bi-cells, in the order of CGAL's list of facets.
    [[nodiscard]] std::vector<Bicell_indices<d>> view_bicells() const;
    [[nodiscard]] int view_dimension() const;
    /// CGAL's own check that its cells fit together.
    [[nodiscard]] bool view_is_valid() const;
    /// vertex(i)->point().
    [[nodiscard]] Point view_point(Index i) const;
    /// Its points, in the order of its list of vertices.
    [[nodiscard]] std::vector<Point> view_points() const;
    /// position(vertex(i)).
    [[nodiscard]] Point position(Index i) const;
    /// The vertex that the handle of an index refers to; null at a free index.
    [[nodiscard]] const void* handle(Index i) const;
    /// index(vertex(i)).
    [[nodiscard]] Index handle_index(Index i) const;

  private:
    std::unique_ptr<Viewed<d>> viewed_;
};

/// As cells_of(triangulation()) of Moving_delaunay.
template <int d>
[[nodiscard]] oracle::Cells_of<d> cells_of(const Viewed_mesh<d>& dt) {
    return dt.view_cells();
}

extern template class Viewed_mesh<2>;
extern template class Viewed_mesh<3>;

using Viewed_mesh_2 = Viewed_mesh<2>;
using Viewed_mesh_3 = Viewed_mesh<3>;

}  // namespace annulus::testing
