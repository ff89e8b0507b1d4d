// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/domain_3.h>

#include <array>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The corners of the facet opposite to corner i of a positive cell, counter-clockwise seen from outside of the cell.
inline constexpr std::array<std::array<std::size_t, 3>, 4> facet_corners{{{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Cells with their adjacency. Throws Error(unknown_vertex) for an index outside [0, n), Error(bad_input) when three
/// cells share a facet. O(n), by sorting facets on their least vertex.
[[nodiscard]] Mesh_cells<3> linked(std::vector<std::array<Index, 4>> cells, std::size_t n, int threads = 1);

/// The signed volume of a cell, and this volume times the vector from the first corner to the circumcentre. There is no
/// division, so that the values of a flat cell, whose circumcentre may be anywhere, are small, too.
struct Cell_moment {
    Coordinates<3> moment{};
    double volume = 0;
};
[[nodiscard]] Cell_moment cell_moment(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c,
                                      const Coordinates<3>& d);
/// Whether the circumcentre of the cell with first corner a is in the domain. False where it is not a finite point in
/// doubles.
[[nodiscard]] bool is_inside(const Domain_3& domain, const Coordinates<3>& a, const Cell_moment& cell);

/// Which cells belong to the domain: those whose circumcentre it contains (the restricted Delaunay triangulation, as in
/// the meshes of Mesh_3). A flat cell, whose circumcentre is not a finite point in doubles, does not. The result does
/// not depend on the number of threads.
[[nodiscard]] std::vector<char> cells_inside(const Domain_3& domain, const Mesh_cells<3>& cells,
                                             std::span<const Coordinates<3>> position, int threads = 1);

/// The facets between a cell with a flag and one without or infinity, counter-clockwise from outside, in the order of
/// the cells.
[[nodiscard]] std::vector<std::array<Index, 3>> surface_facets(const Mesh_cells<3>& cells, std::span<const char> inside,
                                                               int threads = 1);

}  // namespace annulus::inline v1
