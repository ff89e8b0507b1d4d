// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// References of the fuzz targets and the property tests: a fresh CGAL triangulation of the same points, and the
// tolerance of a vertex in rational arithmetic. Nothing here calls the library's arithmetic.

#include "cells.h"
#include "half_widths.h"
#include "motion.h"

#include <annulus/moving_delaunay_2.h>

#include <gmpxx.h>

#include <algorithm>
#include <vector>

namespace annulus::oracle {

/// The library's class of one dimension, and its points.
template <int d>
struct Space;

template <>
struct Space<2> {
    using Moving = Moving_delaunay_2;
    static Moving::Point point(const Coordinates<2>& p) { return {p[0], p[1]}; }
    static Coordinates<2> coordinates(const Moving::Point& p) { return {p.x(), p.y()}; }
};

using Sites = Sites_of<2>;

/// The finite cells of any 2D triangulation whose vertices have an `index()`.
template <class Triangulation>
[[nodiscard]] Cells cells_of(const Triangulation& tr) requires requires {
    tr.finite_faces_begin();
}
{
    Cells cells;
    if (tr.dimension() == 2)
        for (auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
            cells.push_back(canonical({f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()}));
    if (tr.dimension() == 1)
        for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
            cells.push_back(canonical({e->first->vertex(0)->index(), e->first->vertex(1)->index(), none}));
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// The same for CGAL's Delaunay triangulation of the sites, newly built.
[[nodiscard]] Cells rebuilt_cells(const Sites& sites);

// ---- Tolerances in rational arithmetic ----------------------------------------------------------------------------

/// The least tolerance of the certificates of every vertex of a Delaunay triangulation of the sites; by index, 0 for
/// a free one and for sites on one line.
[[nodiscard]] std::vector<mpf_class> vertex_tolerances(const Moving_delaunay_2::Triangulation& tr, const Sites& sites);

}  // namespace annulus::oracle
