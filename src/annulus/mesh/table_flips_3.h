// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <array>
#include <optional>

namespace annulus {

// Flips of a 3D table, with infinity among the vertices like any other. They say nothing of positions, and do
// not ask whether an edge comes to be there twice: the cells stay glued to a manifold, whatever the flips
// (docs/theory.md 6.2). Where two of the cells beside those that go are among those that go, they answer false and
// change nothing. O(1).

/// 2-3: the facet at half-facet h goes, the edge between its opposite vertices comes. `made` receives the three
/// cells, which have the numbers of the two that went and one more.
[[nodiscard]] bool flip_facet(Corner_table<3>& t, Corner_index h, std::array<Cell_index, 3>& made);

/// 3-2: the edge of the facet at half-facet h that lies opposite to the vertex of corner k, a corner of the same
/// cell, goes if three cells share it; the triangle of the vertices around it comes. `made` receives the two cells,
/// which keep numbers, and the one that is gone.
[[nodiscard]] bool flip_edge(Corner_table<3>& t, Corner_index h, Corner_index k, std::array<Cell_index, 3>& made);

/// The cells around an edge that four cells share, and the two edges that could be there instead of it.
struct Flip_4_4 {
    std::array<Cell_index, 4> gone;
    std::array<std::array<Site<3>, 4>, 4> came;  ///< corners, in positive order if the cell is positive
};
/// 4-4: an edge that four cells share gives way to the edge of the opposite vertices of the facet at half-facet h.
/// The edge is the one of that facet that lies opposite to the vertex of corner k, a corner of the same cell. Nothing
/// where not four cells share it.
[[nodiscard]] std::optional<Flip_4_4> flip_4_4(const Corner_table<3>& t, Corner_index h, Corner_index k);

}  // namespace annulus
