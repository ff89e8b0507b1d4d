// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle_3.h"

#include "rational_3.h"

#include <annulus/arithmetic/limits.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <set>

namespace annulus::oracle {

Cells_of<3> rebuilt_cells(const Sites_of<3>& sites) {
    Delaunay_3<No_info> tr;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites[i]) tr.insert(Space<3>::point(*sites[i]))->set_index(static_cast<Index>(i));
    return cells_of(tr);
}

std::string view_fault(const Moving_delaunay_3& dt) {
    const auto& tr = dt.triangulation();
    if (tr.dimension() != 3) return {};
    const auto& t = dt.mesh().table();
    std::size_t cells = 0;
    for (Cell_index c(0); c < t.cell_bound(); ++c) cells += t.is_cell(c) ? 1U : 0U;
    if (cells != tr.number_of_cells()) return "the mesh has another number of cells";
    std::set<Corner_index> facets;
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) {
        const Cell_index k(c->cell());
        if (!t.is_cell(k)) return "a cell is none of the mesh";
        for (int i = 0; i <= 3; ++i) {
            const Corner_index h = t.corner(k, i);
            const Index v = tr.is_infinite(c->vertex(i)) ? infinite : c->vertex(i)->index();
            if (t.vertex(h) != v) return "a corner of the mesh has another vertex";
            if (t.twin(h) != t.corner(Cell_index(c->neighbor(i)->cell()), tr.tds().mirror_index(c, i)))
                return "a corner of the mesh has another neighbour";
            if (t.facet(h) != t.facet(t.twin(h)) || !t.is_facet(t.facet(h))) return "a facet of the mesh is wrong";
            if (t.facet(h) != h && t.facet(h) != t.twin(h)) return "a facet has a foreign half";
            facets.insert(t.facet(h));
            if (v != infinite && t.vertex(t.corner_of(v)) != v) return "a vertex has a foreign corner";
        }
    }
    if (facets.size() != 2 * cells) return "two facets share a number";
    std::size_t counted = 0;
    for (Corner_index f(0); f < t.facet_bound(); ++f) counted += t.is_facet(f) ? 1U : 0U;
    return counted == facets.size() ? std::string() : "a facet is counted twice";
}

std::string tolerance_fault(const Moving_delaunay_3& dt) {
    const auto& tr = dt.triangulation();
    if (tr.dimension() != 3) return {};
    using Vertex_handle = Moving_delaunay_3::Vertex_handle;
    std::vector<char> reached(dt.index_bound(), 0);  // some certificate is not much wider
    const auto at = [&](Vertex_handle v) -> const Coordinates<3>& {
        return dt.positions()[static_cast<std::size_t>(v->index())];
    };
    std::string fault;
    const auto take = [&](std::initializer_list<Vertex_handle> points, const Half_width_3& h, const Half_width_3& all) {
        for (const Vertex_handle v : points) {
            const double s = dt.tolerance(v);
            const auto name = [v] { return "the tolerance of vertex " + std::to_string(v->index()); };
            if (h.sign() > 0 ? !h.is_at_least(s) : s > 0.0) fault = name() + " is above the truth";
            // Rounding to subnormal numbers may lose all accuracy.
            if (h.sign() <= 0 || !all.is_at_least(std::max(1.004 * s, 0x1p-1000)))
                reached[static_cast<std::size_t>(v->index())] = 1;
        }
    };
    for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c) {
        const Half_width_3 h = simplex({&at(c->vertex(0)), &at(c->vertex(1)), &at(c->vertex(2)), &at(c->vertex(3))});
        take({c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3)}, h, h);
    }
    for (auto f = tr.all_facets_begin(); f != tr.all_facets_end(); ++f) {
        const auto q = f->first->vertex(f->second);
        const auto p = tr.mirror_vertex(f->first, f->second);
        std::array<Vertex_handle, 3> v;
        for (int i = 0; i < 3; ++i) v[static_cast<std::size_t>(i)] = f->first->vertex((f->second + 1 + i) & 3);
        const auto infinite_one = std::find(v.begin(), v.end(), tr.infinite_vertex());
        if (infinite_one != v.end()) {
            std::swap(*infinite_one, v[2]);
            Tuple<3, 4> x{&at(v[0]), &at(v[1]), &at(p), &at(q)};
            if (simplex(x).sign() < 0) std::swap(x[0], x[1]);
            const Half_width_3 h = simplex(x);
            take({v[0], v[1], p, q}, h, h);
        } else if (!tr.is_infinite(p) && !tr.is_infinite(q)) {
            Tuple<3, 5> x{&at(v[0]), &at(v[1]), &at(v[2]), &at(p), &at(q)};
            if (simplex({x[0], x[1], x[2], x[4]}).sign() < 0) std::swap(x[0], x[1]);
            take({v[0], v[1], v[2], p, q}, least_annulus(x), least_annulus_and_cells(x));
        }
    }
    for (std::size_t i = 0; i < reached.size() && fault.empty() && !Limits::tiny; ++i)
        if (dt.vertex(i) != Vertex_handle() && reached[i] == 0)
            fault = "the tolerance of vertex " + std::to_string(i) + " is far below the truth";
    return fault;
}

}  // namespace annulus::oracle
