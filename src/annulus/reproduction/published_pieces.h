// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/certificate_survey.h>
#include <annulus/reproduction/standard_annulus.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace annulus {

/// The operations of CGAL's triangulation that the paper's algorithms need, with the same names in 2D and 3D.
template <int d>
struct Published_pieces;

template <>
struct Published_pieces<2> {
    using Triangulation = Moving_delaunay_2::Triangulation;
    using Vertex = Triangulation::Vertex_handle;
    using Cell = Triangulation::Face_handle;
    using Point = Triangulation::Point;

    static Point point(const Coordinates<2>& x) { return {x[0], x[1]}; }
    static Cell cell_of(Vertex v) { return v->face(); }
    static void append_star(const Triangulation& tr, Vertex v, std::vector<Cell>& out) {
        auto c = tr.incident_faces(v);
        const auto end = c;
        do out.push_back(c);
        while (++c != end);
    }
    static bool is_positive(const Triangulation& tr, Cell c) {
        return tr.is_infinite(c) || CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(),
                                                      c->vertex(2)->point()) == CGAL::LEFT_TURN;
    }
    /// For a cell that may be infinite; cocircular points are perturbed as in CGAL.
    static bool sphere_holds(const Triangulation& tr, Cell c, Vertex v) {
        return tr.side_of_oriented_circle(c, v->point(), true) == CGAL::ON_POSITIVE_SIDE;
    }
    /// Removes v; appends the cells that fill its star.
    static void remove(Triangulation& tr, Vertex v, std::vector<Cell>& out) {
        std::vector<std::pair<Cell, int>> border;
        auto c = tr.incident_faces(v);
        const auto end = c;
        do {
            const int i = c->index(v);
            border.emplace_back(c->neighbor(i), tr.mirror_index(c, i));
        } while (++c != end);
        tr.remove(v);
        // They form a triangulated polygon: each is reached from its border or from another one of them.
        const std::size_t first = out.size();
        const auto enter = [&](Cell f) {
            for (const auto& b : border)
                if (b.first == f) return;
            if (std::find(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), f) == out.end())
                out.push_back(f);
        };
        for (const auto& [f, i] : border) enter(f->neighbor(i));
        for (std::size_t k = first; k < out.size(); ++k)
            for (int i = 0; i < 3; ++i) enter(out[k]->neighbor(i));
    }
    template <class Visit>
    static void for_each_cell(const Triangulation& tr, Visit visit) {
        for (auto c = tr.all_faces_begin(); c != tr.all_faces_end(); ++c) visit(Cell(c));
    }
    static Cell_sites<2> slab(const Cell_sites<2>& cell, std::size_t slot) {
        return {cell[(slot + 1) % 3], cell[(slot + 2) % 3], cell[slot]};
    }
};

template <>
struct Published_pieces<3> {
    using Triangulation = Moving_delaunay_3::Triangulation;
    using Vertex = Triangulation::Vertex_handle;
    using Cell = Triangulation::Cell_handle;
    using Point = Triangulation::Point;

    static Point point(const Coordinates<3>& x) { return {x[0], x[1], x[2]}; }
    static Cell cell_of(Vertex v) { return v->cell(); }
    static void append_star(const Triangulation& tr, Vertex v, std::vector<Cell>& out) {
        tr.incident_cells(v, std::back_inserter(out));
    }
    static bool is_positive(const Triangulation& tr, Cell c) {
        return tr.is_infinite(c) || CGAL::orientation(c->vertex(0)->point(), c->vertex(1)->point(),
                                                      c->vertex(2)->point(), c->vertex(3)->point()) == CGAL::POSITIVE;
    }
    static bool sphere_holds(const Triangulation& tr, Cell c, Vertex v) {
        return tr.side_of_sphere(c, v->point(), true) == CGAL::ON_BOUNDED_SIDE;
    }
    static void remove(Triangulation& tr, Vertex v, std::vector<Cell>& out) {
        tr.remove_and_give_new_cells(v, std::back_inserter(out));
    }
    template <class Visit>
    static void for_each_cell(const Triangulation& tr, Visit visit) {
        for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) visit(Cell(c));
    }
    static Cell_sites<3> slab(const Cell_sites<3>& cell, std::size_t slot) {
        const auto& facing = facing_corners[slot];
        return {cell[static_cast<std::size_t>(facing[0])], cell[static_cast<std::size_t>(facing[1])],
                cell[static_cast<std::size_t>(facing[2])], cell[slot]};
    }
};

}  // namespace annulus
