// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
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

}  // namespace annulus::inline v1
