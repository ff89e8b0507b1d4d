// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/flip_repair.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/table_flips_3.h>

#include <array>
#include <vector>

namespace annulus::inline v1 {

/// One of the two triangulations of five points is locally Delaunay: 2-3 where the edge of the opposite vertices
/// crosses the facet, 3-2 where it passes outside (pictures: flip_repair.h). Where four of the points are coplanar,
/// 4-4 if the two edges cross.
template <>
bool Flip_repair<3>::flip(Corner_index h) {
    const Cell_sites<3> x = facet_and_vertex(table_, h);
    const Site<3> q = x[3];
    const Site<3> p = table_.opposite(h);
    if (p == q) return false;
    std::array<int, 3> passes{};  // how pq passes the edge opposite to x[i]: 1 on its inner side, 0 through it
    int beside = 0;
    std::size_t odd = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        passes[i] = signs_.sign({x[(i + 1) % 3], x[(i + 2) % 3], p, q});
        if (passes[i] > 0) continue;
        ++beside;
        odd = i;
    }
    if (beside == 0) {
        std::array<Cell_index, 3> cells{};
        if (!flip_facet(table_, h, cells)) return false;
        made(cells);
        return true;
    }
    if (beside > 1) return false;
    const Cell_index c = table_.cell_of(h);
    if (passes[odd] < 0) {
        std::array<Cell_index, 3> cells{};
        if (!flip_edge(table_, h, table_.corner(c, table_.slot(c, x[odd])), cells)) return false;
        result_.touched.push_back(cells[2]);
        made(std::span(cells).first(2));
        return true;
    }
    const auto flip = flip_4_4(table_, h, table_.corner(c, table_.slot(c, x[odd])));
    if (!flip || p.vertex == infinite || q.vertex == infinite) return false;
    for (const Cell_sites<3>& cell : flip->came)
        if (signs_.sign(cell) <= 0) return false;
    std::vector<Cell_index> cells;
    replace_cells<3>(table_, flip->gone, flip->came, cells);
    result_.touched.insert(result_.touched.end(), flip->gone.begin(), flip->gone.end());
    made(cells);
    return true;
}

/// A cell at the hull that its vertex inverted by leaving: flips the facet of the hull that the vertex crossed. Not
/// if another neighbour is inverted: then more is wrong than this flip can tell.
template <>
bool Flip_repair<3>::untangle(Cell_index c) {
    if (table_.is_infinite(c)) return false;
    for (int i = 0; i <= 3; ++i) {
        const Corner_index h = table_.corner(c, i);
        if (!table_.is_infinite(table_.cell_of(table_.twin(h)))) continue;
        bool alone = true;
        for (int j = 0; j <= 3; ++j) {
            const Cell_index n = table_.cell_of(table_.twin(table_.corner(c, j)));
            alone = alone && (j == i || table_.is_infinite(n) || !signs_.is_inverted(n));
        }
        if (!alone) continue;
        if (flip(h)) return true;
    }
    return false;
}

}  // namespace annulus::inline v1
