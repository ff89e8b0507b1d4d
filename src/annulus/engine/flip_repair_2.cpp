// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/flip_repair.h>

#include <array>

namespace annulus::inline v1 {

namespace {

/// The two triangles of the bi-cell at h with the other diagonal.
std::array<Cell_sites<2>, 2> flipped(const Corner_table<2>& t, Corner_index h) {
    const Site<2> q = t.site(h);
    const Site<2> p = t.opposite(h);
    return {{{q, t.site(t.ccw(h)), p}, {p, t.site(t.cw(h)), q}}};
}

}  // namespace

template <>
bool Flip_repair<2>::flip(Corner_index h) {
    const std::array<Cell_index, 2> cells{table_.cell_of(h), table_.cell_of(table_.twin(h))};
    if (table_.site(h) == table_.opposite(h)) return false;
    for (const Corner_index k : {table_.ccw(h), table_.cw(h), table_.ccw(table_.twin(h)), table_.cw(table_.twin(h))}) {
        const Cell_index beside = table_.cell_of(table_.twin(k));
        if (beside == cells[0] || beside == cells[1]) return false;  // it would become its own neighbour
    }
    for (const Cell_sites<2>& x : flipped(table_, h))
        if (signs_.sign(x) <= 0) return false;
    table_.flip(h);
    made(cells);
    return true;
}

/// A triangle at the border that its vertex inverted by leaving: flips the edge of the border that the vertex
/// crossed.
template <>
bool Flip_repair<2>::untangle(Cell_index c) {
    for (int i = 0; i <= 2; ++i) {
        const Corner_index h = table_.corner(c, i);
        if (table_.is_infinite(c) != table_.is_infinite(table_.cell_of(table_.twin(h))) && flip(h)) return true;
    }
    return false;
}

}  // namespace annulus::inline v1
