// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/mesh/index.h>

#include <array>
#include <span>
#include <vector>

namespace annulus {

/// The Delaunay triangulation of vertices that lie in a hyperplane, and of infinity: segments between neighbours on a
/// line, triangles in a plane of space, each with infinity where it is a facet's of the hull. All cells are turned the
/// same way.
struct Flat_cells {
    int dimension = -1;                            ///< affine, of the vertices; there are cells where it is 1 or 2
    std::vector<std::array<Index, 3>> vertices;    ///< dimension + 1 a cell, then `none`
    std::vector<std::array<Index, 3>> neighbours;  ///< the cell opposite to each vertex, then `none`
};

/// Of these vertices, at x; some of them, in any order, where they are in one place of x each. O(n log n).
template <int d>
[[nodiscard]] Flat_cells flat_cells(std::span<const Coordinates<d>> x, std::vector<Index> vertices);

/// Throws Error(duplicate_point) naming two vertices that are at one place. O(n log n).
template <int d>
void require_distinct(std::span<const Coordinates<d>> x, std::vector<Index> vertices);

/// Whether p is outside of the affine hull of points that are affinely independent, d of them at most. O(1).
template <int d>
[[nodiscard]] bool spans_more(std::span<const Coordinates<d>* const> independent, const Coordinates<d>& p);

#define ANNULUS_FLAT(d)                                                                            \
    extern template Flat_cells flat_cells<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    extern template void require_distinct<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    extern template bool spans_more<d>(std::span<const Coordinates<d>* const>, const Coordinates<d>&);
ANNULUS_FLAT(2)
ANNULUS_FLAT(3)
#undef ANNULUS_FLAT

}  // namespace annulus
