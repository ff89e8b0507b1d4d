// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <array>
#include <optional>

namespace annulus::inline v1 {

/*
            c                                c
           / \                              /|\
          /   \          flip_facet        / | \
         /     \            -->           /  o  \          o: the edge p q
        /       \                        / _/ \_ \
       /         \                      /_/     \_\
      a-----------b                    a-----------b
    cells a b c q, b a c p          cells a b p q, b c p q, c a p q
*/
// Flips of a 3D table, with infinity among the vertices like any other. They do not use positions, and do not check
// whether an edge would then exist twice: the cells stay glued to a manifold whatever the flips (docs/theory.md 6.2).
// Where a cell beside the removed ones is one of them, they return false, or nothing, and change nothing; nor when they
// throw: bad_alloc, and flip_facet Error(too_large). O(1), amortised.
//
// The picture: 2-3, seen from q along the edge p q.

/// 2-3: replaces the facet a b c at half-facet h by the edge between its opposite vertices p and q. `made` receives
/// the three cells, which have the indices of the two old cells and a new one.
[[nodiscard]] bool flip_facet(Corner_table<3>& t, Corner_index h, std::array<Cell_index, 3>& made);

/*
      c                  c
     / \                /|\         In the plane of the facet a b c at h; q is above it, p below, and p q meets
    /   \              / | \        it at x, beyond a b. c is the vertex of corner k.
   a-----b     ->     a  |  b
    \   /              \ | /        cells a b c q, b a c p, a b q p  ->  c q p b, q c p a
     \ /                \|/
      x                  x
*/
/// 3-2: removes the edge a b, which lies opposite to the vertex c of corner k in the facet at half-facet h, if three
/// cells share it, and creates the triangle c p q. Precondition: k is another corner of the cell of h. `made` receives
/// the two new cells, which keep two of the old indices, and the cell that is gone.
[[nodiscard]] bool flip_edge(Corner_table<3>& t, Corner_index h, Corner_index k, std::array<Cell_index, 3>& made);

/// The cells around an edge that four cells share, and those around the edge that would replace it.
struct Flip_4_4 {
    std::array<Cell_index, 4> gone;
    std::array<std::array<Site<3>, 4>, 4> came;  ///< corners, in positive order if the cell is positive
};
/*
       q                      q
      / \                    /|\
     /   \                  / | \
    u-----w       ->       u  |  w
     \   /                  \ | /
      \ /                    \|/
       p                      p
*/
/// 4-4: replacing an edge u w that four cells share by the edge of the opposite vertices p and q of the facet at
/// half-facet h. Returns the cells that this would remove and create; the table is not changed. u w is the edge of that
/// facet that lies opposite to the vertex c of corner k. Precondition: k is another corner of the cell of h. Returns
/// nothing if not exactly four cells share u w. Each triangle of the picture makes one cell with c, behind it, and one
/// with r, in front of it.
[[nodiscard]] std::optional<Flip_4_4> flip_4_4(const Corner_table<3>& t, Corner_index h, Corner_index k);

}  // namespace annulus::inline v1
