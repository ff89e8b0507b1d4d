// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/traits.h>
#include <annulus/internal/types_2.h>

#include <type_traits>

namespace annulus::inline v1 {

/// What Cgal_view uses of CGAL's 2D triangulation. Its cells are faces.
template <class Gt, class Tds_>
struct Cgal_traits<CGAL::Delaunay_triangulation_2<Gt, Tds_>> {
    static_assert(std::is_same_v<Gt, Kernel>,
                  "the kernel must be CGAL's Exact_predicates_inexact_constructions_kernel");
    static constexpr int dimension = 2;
    using Triangulation = CGAL::Delaunay_triangulation_2<Gt, Tds_>;
    using Point = typename Triangulation::Point;
    using Vertex = typename Triangulation::Vertex;
    using Cell = typename Triangulation::Face;
    using Vertex_handle = typename Triangulation::Vertex_handle;
    using Cell_handle = typename Triangulation::Face_handle;
    using Tds = typename Triangulation::Triangulation_data_structure;

    [[nodiscard]] static Coordinates<2> coordinates(const Point& p) { return {p.x(), p.y()}; }
    [[nodiscard]] static Point point(const Coordinates<2>& x) { return {x[0], x[1]}; }

    [[nodiscard]] static Cell_handle cell_of(Vertex_handle v) { return v->face(); }
    static void set_cell_of(Vertex_handle v, Cell_handle c) { v->set_face(c); }
    [[nodiscard]] static auto& cells(Tds& tds) { return tds.faces(); }
    /// Visits every cell, including those with infinity. Precondition: dimension 2.
    template <class Visit>
    static void for_each_cell(const Triangulation& tr, Visit visit) {
        for (auto c = tr.all_faces_begin(); c != tr.all_faces_end(); ++c) visit(Cell_handle(c));
    }
    [[nodiscard]] static Cell_handle create_cell(Tds& tds) { return tds.create_face(); }
    static void delete_cell(Tds& tds, Cell_handle c) { tds.delete_face(c); }
};

/// With the caller's Info at the vertices.
template <class Info>
using Cgal_traits_2 = Cgal_traits<Delaunay_2<Info>>;

}  // namespace annulus::inline v1
