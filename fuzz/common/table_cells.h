// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <set>

// The contents of a table, in a form that does not depend on numbers of cells and order of corners.
namespace annulus::oracle {

template <int d>
using Cell_set = std::set<Cell_vertices<d>>;

/// Cells as sets of vertices, including infinite ones.
template <int d>
[[nodiscard]] Cell_set<d> cells_of(const Corner_table<d>& t) {
    Cell_set<d> cells;
    for (const Cell_index c : t.cells()) {
        auto v = cell_vertices(t, c);
        std::sort(v.begin(), v.end());
        cells.insert(v);
    }
    return cells;
}

/// Whether twins are mutual and share their vertices.
template <int d>
[[nodiscard]] bool glued(const Corner_table<d>& t) {
    for (const Cell_index c : t.cells())
        for (int i = 0; i <= d; ++i) {
            const Corner_index h = t.corner(c, i), k = t.twin(h);
            if (t.twin(k) != h) return false;
            auto a = cell_sites(t, c), b = cell_sites(t, t.cell_of(k));
            a[static_cast<std::size_t>(t.slot_of(h))] = b[static_cast<std::size_t>(t.slot_of(k))] = Site<d>(none);
            std::sort(a.begin(), a.end());
            std::sort(b.begin(), b.end());
            if (a != b) return false;
        }
    return true;
}

}  // namespace annulus::oracle
