// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// As oracle.h, in 3D: a fresh CGAL triangulation, the view corner for corner, and tolerances in rational arithmetic.

#include "oracle.h"

#include <annulus/moving_delaunay_3.h>

#include <string>

namespace annulus::oracle {

template <>
struct Space<3> {
    using Moving = Moving_delaunay_3;
    static Moving::Point point(const Coordinates<3>& p) { return {p[0], p[1], p[2]}; }
    static Coordinates<3> coordinates(const Moving::Point& p) { return {p.x(), p.y(), p.z()}; }
};

/// The finite cells of any 3D triangulation whose vertices have an `index()`; triangles and edges where there
/// are no cells.
template <class Triangulation>
[[nodiscard]] Cells_of<3> cells_of(const Triangulation& tr) requires requires {
    tr.finite_cells_begin();
}
{
    Cells_of<3> cells;
    const auto take = [&cells](std::initializer_list<Index> v) {
        std::array<Index, 4> c{none, none, none, none};
        std::copy(v.begin(), v.end(), c.begin());
        std::sort(c.begin(), c.end());
        cells.push_back(c);
    };
    if (tr.dimension() == 3)
        for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
            take({c->vertex(0)->index(), c->vertex(1)->index(), c->vertex(2)->index(), c->vertex(3)->index()});
    if (tr.dimension() == 2)
        for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
            take({f->first->vertex(0)->index(), f->first->vertex(1)->index(), f->first->vertex(2)->index()});
    if (tr.dimension() == 1)
        for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
            take({e->first->vertex(e->second)->index(), e->first->vertex(e->third)->index()});
    std::sort(cells.begin(), cells.end());
    return cells;
}

[[nodiscard]] Cells_of<3> rebuilt_cells(const Sites_of<3>& sites);

/// Empty, or how the mesh differs from CGAL's object, compared corner by corner.
[[nodiscard]] std::string view_fault(const Moving_delaunay_3& dt);

/// Empty, or the fault of recomputed tolerances: each must be at most the half width of every certificate that contains
/// the vertex, and not far below the least of these and of the cells of its bi-cells. Not checked where the points are
/// flat.
[[nodiscard]] std::string tolerance_fault(const Moving_delaunay_3& dt);

}  // namespace annulus::oracle
