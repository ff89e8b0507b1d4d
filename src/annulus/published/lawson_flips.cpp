// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/published/lawson_flips.h>

#include <array>

namespace annulus::inline v1 {

/// If all triangles of a triangulation are positive, such flips lead to the Delaunay triangulation in any order
/// (Lawson). Each of them flips a strictly convex quadrilateral; with the symbolic perturbation no edge is
/// degenerate.
bool flip_after_move(Corner_table<2>& table, std::span<const Coordinates<2>> x, Index v, Sign_evaluator<2>& signs,
                     std::vector<Cell_index>& changed) {
    Budget budget;
    signs.begin(x, budget);
    bool positive = true;
    std::vector<Corner_index> edges;
    table.for_each_corner(v, [&](Corner_index h) {
        const Cell_index c = table.cell_of(h);
        positive = positive && !table.is_infinite(c) && !signs.is_inverted(c);
        edges.push_back(h);
        edges.push_back(table.ccw(h));
    });
    if (!positive) return false;
    while (!edges.empty()) {
        const Corner_index h = edges.back();
        edges.pop_back();
        if (!signs.is_violated(table.facet(h))) continue;
        const std::array<Cell_index, 2> cells{table.cell_of(h), table.cell_of(table.twin(h))};
        table.flip(h);
        for (const Cell_index c : cells) {
            changed.push_back(c);
            for (int i = 0; i <= 2; ++i) edges.push_back(table.corner(c, i));
        }
    }
    return true;
}

}  // namespace annulus::inline v1
