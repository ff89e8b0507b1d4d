// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <span>
#include <vector>

namespace annulus {

/// Inserts v into a table that is Delaunay without it, at x, which has a place for v that no other vertex has. `first`
/// is a cell that holds this place, or one with infinity whose facet it is beyond. `changed` receives the new cells.
///
/// By Bowyer and Watson: the cells whose sphere holds v make way for cells between their border and v. Exact; where
/// points are cospherical, by the perturbation that decides all else (theory 6.7), so that the cells are those of a
/// construction, and none is flat. Expected O(degree of v). Throws Error(too_large) and bad_alloc, with the table half
/// way.
template <int d>
void insert_vertex(Corner_table<d>& t, std::span<const Coordinates<d>> x, Cell_index first, Index v,
                   std::vector<Cell_index>& changed);

extern template void insert_vertex<2>(Corner_table<2>&, std::span<const Coordinates<2>>, Cell_index, Index,
                                      std::vector<Cell_index>&);
extern template void insert_vertex<3>(Corner_table<3>&, std::span<const Coordinates<3>>, Cell_index, Index,
                                      std::vector<Cell_index>&);

}  // namespace annulus
