// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/traits.h>
#include <annulus/internal/types_3.h>

#include <type_traits>

namespace annulus::inline v1 {

/// What Cgal_view uses of CGAL's 3D triangulation.
template <class Gt, class Tds_, class Location, class Lock>
struct Cgal_traits<CGAL::Delaunay_triangulation_3<Gt, Tds_, Location, Lock>> {
    static_assert(std::is_same_v<Gt, Kernel>,
                  "the kernel must be CGAL's Exact_predicates_inexact_constructions_kernel");
    static constexpr int dimension = 3;
    using Triangulation = CGAL::Delaunay_triangulation_3<Gt, Tds_, Location, Lock>;
    using Point = typename Triangulation::Point;
    using Vertex = typename Triangulation::Vertex;
    using Cell = typename Triangulation::Cell;
    using Vertex_handle = typename Triangulation::Vertex_handle;
    using Cell_handle = typename Triangulation::Cell_handle;
    using Tds = typename Triangulation::Triangulation_data_structure;

    [[nodiscard]] static Coordinates<3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
    [[nodiscard]] static Point point(const Coordinates<3>& x) { return {x[0], x[1], x[2]}; }

    [[nodiscard]] static Cell_handle cell_of(Vertex_handle v) { return v->cell(); }
    static void set_cell_of(Vertex_handle v, Cell_handle c) { v->set_cell(c); }
    [[nodiscard]] static auto& cells(Tds& tds) { return tds.cells(); }
    /// Visits every cell, including those with infinity. Precondition: dimension 3.
    template <class Visit>
    static void for_each_cell(const Triangulation& tr, Visit visit) {
        for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) visit(Cell_handle(c));
    }
    [[nodiscard]] static Cell_handle create_cell(Tds& tds) { return tds.create_cell(); }
    static void delete_cell(Tds& tds, Cell_handle c) { tds.delete_cell(c); }
};

/// With the caller's Info at the vertices.
template <class Info>
using Cgal_traits_3 = Cgal_traits<Delaunay_3<Info>>;

}  // namespace annulus::inline v1
