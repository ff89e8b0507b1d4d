// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "table_cells.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <annulus/types.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace annulus::oracle {

/// Dimension and cells of CGAL's triangulation of the existing points, which differ; no cells where they are flat.
template <int d>
[[nodiscard]] std::pair<int, Cell_set<d>> cells_by_cgal(const std::vector<std::optional<Coordinates<d>>>& x) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    Cell_set<d> cells;
    std::map<Coordinates<d>, Index> index;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (x[i]) index.emplace(*x[i], static_cast<Index>(i));
    const auto list = [&](const auto& tr, auto cell) {
        Cell_vertices<d> v{};
        for (int k = 0; k <= d; ++k) {
            const auto w = cell->vertex(k);
            Coordinates<d> p{};
            for (int c = 0; c < d && !tr.is_infinite(w); ++c) p[static_cast<std::size_t>(c)] = w->point()[c];
            v[static_cast<std::size_t>(k)] = tr.is_infinite(w) ? infinite : index.at(p);
        }
        std::sort(v.begin(), v.end());
        cells.insert(v);
    };
    if constexpr (d == 2) {
        CGAL::Delaunay_triangulation_2<Kernel> tr;
        for (const auto& p : x)
            if (p) tr.insert(Kernel::Point_2((*p)[0], (*p)[1]));
        if (tr.dimension() == d)
            for (auto f = tr.all_faces_begin(); f != tr.all_faces_end(); ++f) list(tr, f);
        return {tr.dimension(), cells};
    } else {
        CGAL::Delaunay_triangulation_3<Kernel> tr;
        for (const auto& p : x)
            if (p) tr.insert(Kernel::Point_3((*p)[0], (*p)[1], (*p)[2]));
        if (tr.dimension() == d)
            for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) list(tr, c);
        return {tr.dimension(), cells};
    }
}

}  // namespace annulus::oracle
