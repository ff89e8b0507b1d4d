// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Corner_table::flip, the flip in 2D. Included by corner_table.h only.
#include <annulus/mesh/corner_table.h>

namespace annulus::inline v1 {

template <int d>
void Corner_table<d>::flip(Corner_index h) {
    static_assert(d == 2);
    const Corner_index t = twin(h);
    record(cell_of(h));
    record(cell_of(t));
    const Index a = vertex(ccw(h));
    const Index b = vertex(cw(h));
    const Corner_index h_side = twin(ccw(h));  // across the edge b q
    const Corner_index t_side = twin(ccw(t));  // across the edge a p
    // (q, a, b) becomes (q, a, p); (p, b, a) becomes (p, b, q).
    vertex_[cw(h)] = vertex(t);
    vertex_[cw(t)] = vertex(h);
    set_adjacency(h, t_side);
    set_adjacency(t, h_side);
    set_adjacency(ccw(h), ccw(t));
    note_corner(a, ccw(h));
    note_corner(b, ccw(t));
    note_corner(vertex(h), h);
    note_corner(vertex(t), t);
}

}  // namespace annulus::inline v1
