// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/sound_table.h>
#include <annulus/cgal/types_3.h>
#include <annulus/mesh/evaluate.h>

#include <span>

namespace annulus {

/// What Cgal_embedding asks of CGAL's triangulation of space.
template <class Info>
struct Cgal_traits_3 {
    static constexpr int dimension = 3;
    using Triangulation = Delaunay_3<Info>;
    using Point = typename Triangulation::Point;
    using Vertex_handle = typename Triangulation::Vertex_handle;
    using Cell_handle = typename Triangulation::Cell_handle;
    using Tds = typename Triangulation::Triangulation_data_structure;
    /// The same without the caller's data.
    using Plain = Cgal_traits_3<No_info>;

    [[nodiscard]] static Coordinates<3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
    [[nodiscard]] static Point point(const Coordinates<3>& x) { return {x[0], x[1], x[2]}; }

    [[nodiscard]] static Cell_handle cell_of(Vertex_handle v) { return v->cell(); }
    static void set_cell_of(Vertex_handle v, Cell_handle c) { v->set_cell(c); }
    [[nodiscard]] static auto& cells(Tds& tds) { return tds.cells(); }
    /// Every cell, those with infinity too. Precondition: dimension 3.
    template <class Visit>
    static void for_each_cell(const Triangulation& tr, Visit visit) {
        for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) visit(Cell_handle(c));
    }
    [[nodiscard]] static Cell_handle create_cell(Tds& tds) { return tds.create_cell(); }
    static void delete_cell(Tds& tds, Cell_handle c) { tds.delete_cell(c); }
    /// Where the facet opposite to vertex i of c is in the cell beyond it. CGAL's mirror_index takes the first facet that they share;
    /// where tolerances are not certified they may share two.
    [[nodiscard]] static int slot_beyond(const Tds&, Cell_handle c, int i) {
        const Cell_handle n = c->neighbor(i);
        int slot = n->index(c);
        while (slot < 3 && c->has_vertex(n->vertex(slot)) && n->vertex(slot) != c->vertex(i)) {
            int next = slot + 1;
            while (next < 4 && n->neighbor(next) != c) ++next;
            if (next == 4) break;
            slot = next;
        }
        return slot;
    }

    /// Where a point is: inserted there, or where a vertex is already.
    struct Place {
        typename Triangulation::Locate_type type{};
        Cell_handle cell;
        int i = 0;
        int j = 0;
        [[nodiscard]] bool is_vertex() const { return type == Triangulation::VERTEX; }
        [[nodiscard]] Vertex_handle vertex() const { return cell->vertex(i); }
    };
    [[nodiscard]] static Place locate(const Triangulation& tr, const Point& p, Cell_handle near) {
        Place at;
        at.cell = tr.locate(p, at.type, at.i, at.j, near);
        return at;
    }
    [[nodiscard]] static Vertex_handle insert(Triangulation& tr, const Point& p, const Place& at) {
        return tr.insert(p, at.type, at.cell, at.i, at.j);
    }
    [[nodiscard]] static Vertex_handle insert(Triangulation& tr, const Point& p, Vertex_handle near) {
        return near == Vertex_handle() ? tr.insert(p) : tr.insert(p, near);
    }
    static void remove(Triangulation& tr, Vertex_handle v) { tr.remove(v); }
    /// Makes a call that inserts or removes.
    template <class Call>
    static void edit(Call call) {
        cgal_3::with_sound_table(call);
    }
    /// Whether all vertices of `handle` but v are in a plane. `handle` may hold null ones. O(1) unless every finite cell contains v.
    [[nodiscard]] static bool rest_is_flat(const Triangulation& tr, Vertex_handle v, std::span<const Vertex_handle> handle) {
        for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
            if (!c->has_vertex(v)) return false;
        const Cell_handle first = tr.finite_cells_begin();
        const auto& facing = facing_corners[static_cast<std::size_t>(first->index(v))];
        std::array<Coordinates<3>, 4> x{};
        for (std::size_t k = 0; k < 3; ++k) x[k] = coordinates(first->vertex(facing[k])->point());
        for (const Vertex_handle w : handle) {
            if (w == Vertex_handle() || w == v || w->cell() == Cell_handle()) continue;  // vacant, or taken out
            x[3] = coordinates(w->point());
            if (cell_verdict(x).sign != 0) return false;
        }
        return true;
    }
    /// CGAL's removal goes through a map ordered by addresses: the order of its cells, and of their corners, is not the same in
    /// another run of the program. So put_in_order follows each removal: the last bits of a tolerance depend on the
    /// order of corners.
    static constexpr bool shuffles = true;
};

}  // namespace annulus
