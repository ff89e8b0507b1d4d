// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Puts the cells `fresh`, each with its vertices in positive order, infinity among them, in the place of the cells
/// `old`; `made` receives the numbers of the new ones. Precondition: both have the same border, no facet of which is
/// there twice.
/// O(k log k) for k cells.
template <int d>
void replace_cells(Corner_table<d>& t, std::span<const Cell_index> old, std::span<const Cell_sites<d>> fresh,
                   std::vector<Cell_index>& made);

/// What is beyond a facet of a fresh cell: a half-facet of another one, or, where `beyond` is a corner, that.
struct Fresh_neighbour {
    std::uint32_t fresh = 0;  ///< 4 * its place among the fresh cells + slot
    Corner_index beyond = no_corner;
};
template <int d>
using Fresh_neighbours = std::array<Fresh_neighbour, static_cast<std::size_t>(d + 1)>;

/// The same where it is known which cells are neighbours, which has to be mutual. O(k).
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

}  // namespace annulus
