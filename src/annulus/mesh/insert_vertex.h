// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Inserts v into a table that is Delaunay without it, at x. The position of v in x is not that of another vertex.
/// `first` is a cell that holds this position, or an infinite cell if it is beyond that cell's facet. `changed`
/// receives the new cells.
///
/// The algorithm is that of Bowyer and Watson: the cells whose sphere holds v, the cavity, are replaced by the cells
/// between the cavity's border and v. Exact; cospherical points are decided by the perturbation that decides
/// everywhere else (docs/theory.md 6.7), so the cells are those that a construction makes, and none is flat. Expected
/// O(degree of v). Throws Error(too_large) and bad_alloc; the table is then in a partly changed state.
template <int d>
void insert_vertex(Corner_table<d>& t, std::span<const Coordinates<d>> x, Cell_index first, Index v,
                   std::vector<Cell_index>& changed);

extern template void insert_vertex<2>(Corner_table<2>&, std::span<const Coordinates<2>>, Cell_index, Index,
                                      std::vector<Cell_index>&);
extern template void insert_vertex<3>(Corner_table<3>&, std::span<const Coordinates<3>>, Cell_index, Index,
                                      std::vector<Cell_index>&);

}  // namespace annulus::inline v1
