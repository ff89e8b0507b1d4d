// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Replaces the cells `old` by the cells `fresh`, each given by its vertices (infinity included) in positive order.
/// `made` receives the indices of the new cells. Precondition: both sets have the same border, and no facet occurs
/// twice in it. O(k log k) for k cells.
template <int d>
void replace_cells(Corner_table<d>& t, std::span<const Cell_index> old, std::span<const Cell_sites<d>> fresh,
                   std::vector<Cell_index>& made);

/// What is beyond a facet of a fresh cell: `beyond` if that is a corner, otherwise a half-facet of another fresh cell.
struct Fresh_neighbour {
    std::uint32_t fresh = 0;  ///< 4 * its place among the fresh cells + slot
    Corner_index beyond = no_corner;
};
template <int d>
using Fresh_neighbours = std::array<Fresh_neighbour, static_cast<std::size_t>(d + 1)>;

/// The same for known neighbours, which must be mutual. O(k).
template <int d>
void replace_cells(Corner_table<d>& t, std::span<const Cell_index> old, std::span<const Cell_sites<d>> fresh,
                   std::span<const Fresh_neighbours<d>> neighbours, std::vector<Cell_index>& made);

extern template void replace_cells<2>(Corner_table<2>&, std::span<const Cell_index>, std::span<const Cell_sites<2>>,
                                      std::vector<Cell_index>&);
extern template void replace_cells<3>(Corner_table<3>&, std::span<const Cell_index>, std::span<const Cell_sites<3>>,
                                      std::vector<Cell_index>&);
extern template void replace_cells<2>(Corner_table<2>&, std::span<const Cell_index>, std::span<const Cell_sites<2>>,
                                      std::span<const Fresh_neighbours<2>>, std::vector<Cell_index>&);
extern template void replace_cells<3>(Corner_table<3>&, std::span<const Cell_index>, std::span<const Cell_sites<3>>,
                                      std::span<const Fresh_neighbours<3>>, std::vector<Cell_index>&);

}  // namespace annulus::inline v1
