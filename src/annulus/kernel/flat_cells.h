// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/mesh/index.h>

#include <array>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The Delaunay triangulation of vertices that lie in a hyperplane, and of infinity: segments between neighbours on a
/// line, or triangles in a plane in 3D; each facet of the hull makes a cell with infinity. All cells have the same
/// orientation.
struct Flat_cells {
    int dimension = -1;                            ///< affine, of the vertices; there are cells where it is 1 or 2
    std::vector<std::array<Index, 3>> vertices;    ///< dimension + 1 for each cell, then `none`
    std::vector<std::array<Index, 3>> neighbours;  ///< the cell opposite to each vertex, then `none`
};

/// The flat cells of these vertices at x: some of the indices of x, in any order. Precondition: no two of them are at
/// one position. O(n log n).
template <int d>
[[nodiscard]] Flat_cells flat_cells(std::span<const Coordinates<d>> x, std::vector<Index> vertices);

/// Throws Error(duplicate_point), naming two vertices at one position. O(n log n).
template <int d>
void require_distinct(std::span<const Coordinates<d>> x, std::vector<Index> vertices);

/// Whether p is outside the affine hull of affinely independent points, d of them at most. O(1).
template <int d>
[[nodiscard]] bool spans_more(std::span<const Coordinates<d>* const> independent, const Coordinates<d>& p);

#define ANNULUS_FLAT(d)                                                                            \
    extern template Flat_cells flat_cells<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    extern template void require_distinct<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    extern template bool spans_more<d>(std::span<const Coordinates<d>* const>, const Coordinates<d>&);
ANNULUS_FLAT(2)
ANNULUS_FLAT(3)
#undef ANNULUS_FLAT

}  // namespace annulus::inline v1
