// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/types_2.h>

#include <span>

namespace annulus {

/// What Cgal_embedding asks of CGAL's triangulation of the plane. Its cells are faces.
template <class Info>
struct Cgal_traits_2 {
    static constexpr int dimension = 2;
    using Triangulation = Delaunay_2<Info>;
    using Point = typename Triangulation::Point;
    using Vertex_handle = typename Triangulation::Vertex_handle;
    using Cell_handle = typename Triangulation::Face_handle;
    using Tds = typename Triangulation::Triangulation_data_structure;
    /// The same without the caller's data.
    using Plain = Cgal_traits_2<No_info>;

    [[nodiscard]] static Coordinates<2> coordinates(const Point& p) { return {p.x(), p.y()}; }
    [[nodiscard]] static Point point(const Coordinates<2>& x) { return {x[0], x[1]}; }

    [[nodiscard]] static Cell_handle cell_of(Vertex_handle v) { return v->face(); }
    static void set_cell_of(Vertex_handle v, Cell_handle c) { v->set_face(c); }
    [[nodiscard]] static auto& cells(Tds& tds) { return tds.faces(); }
    /// Every cell, those with infinity too. Precondition: dimension 2.
    template <class Visit>
    static void for_each_cell(const Triangulation& tr, Visit visit) {
        for (auto c = tr.all_faces_begin(); c != tr.all_faces_end(); ++c) visit(Cell_handle(c));
    }
    [[nodiscard]] static Cell_handle create_cell(Tds& tds) { return tds.create_face(); }
    static void delete_cell(Tds& tds, Cell_handle c) { tds.delete_face(c); }
    /// Where the facet opposite to vertex i of c is in the cell beyond it.
    [[nodiscard]] static int slot_beyond(const Tds& tds, Cell_handle c, int i) { return tds.mirror_index(c, i); }

    /// Where a point is: inserted there, or where a vertex is already.
    struct Place {
        typename Triangulation::Locate_type type{};
        Cell_handle cell;
        int i = 0;
        [[nodiscard]] bool is_vertex() const { return type == Triangulation::VERTEX; }
        [[nodiscard]] Vertex_handle vertex() const { return cell->vertex(i); }
    };
    [[nodiscard]] static Place locate(const Triangulation& tr, const Point& p, Cell_handle near) {
        Place at;
        at.cell = tr.locate(p, at.type, at.i, near);
        return at;
    }
    [[nodiscard]] static Vertex_handle insert(Triangulation& tr, const Point& p, const Place& at) {
        return tr.insert(p, at.type, at.cell, at.i);
    }
    [[nodiscard]] static Vertex_handle insert(Triangulation& tr, const Point& p, Vertex_handle near) {
        return near == Vertex_handle() ? tr.insert(p) : tr.insert(p, near->face());
    }
    static void remove(Triangulation& tr, Vertex_handle v) { tr.remove(v); }
    /// Makes a call that inserts or removes.
    template <class Call>
    static void edit(Call call) {
        call();
    }
    /// Whether all vertices of `handle` but v are on a line. `handle` may hold null ones.
    [[nodiscard]] static bool rest_is_flat(const Triangulation& tr, Vertex_handle v, std::span<const Vertex_handle>) {
        return tr.test_dim_down(v);
    }
    /// CGAL's removal gives the same cells in the same order in every run.
    static constexpr bool shuffles = false;
};

}  // namespace annulus
