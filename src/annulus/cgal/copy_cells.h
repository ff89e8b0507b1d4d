// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/cell_table.h>
#include <annulus/mesh/parallel_runs.h>

#include <cstddef>
#include <vector>

namespace annulus {

/// Makes `table` what CGAL has: cells[k], which is every cell once, becomes cell k of it, corner by corner, and is told its number.
/// The table does not depend on the number of threads. Precondition: dimension d. O(n).
template <class Traits>
void copy_cells(const typename Traits::Triangulation& tr, const std::vector<typename Traits::Cell_handle>& cells,
                std::size_t vertices, Cell_table<Traits::dimension>& table, int threads) {
    constexpr int d = Traits::dimension;
    constexpr std::size_t run = 1U << 14;
    table.clear(vertices, cells.size());
    for_each_run(cells.size(), run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) cells[k]->set_cell(static_cast<Index>(k));
    });
    for_each_run(cells.size(), run, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t j = first; j < last; ++j) {
            const auto c = cells[j];
            const Cell_index k(static_cast<Index>(j));
            for (int i = 0; i <= d; ++i) {
                const auto v = c->vertex(i);
                table.set_vertex_only(table.corner(k, i), tr.is_infinite(v) ? infinite : v->index());
                // A facet is glued by the lesser of its cells, so no two threads write one entry.
                const Cell_index n(c->neighbor(i)->cell());
                if (n > k) table.glue(table.corner(k, i), table.corner(n, Traits::slot_beyond(tr.tds(), c, i)));
            }
        }
    });
    table.note_corners();
}

}  // namespace annulus
