// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <array>
#include <vector>

namespace annulus {

/// The finite cells of a triangulation in one numbering, 0, 1, 2 .., and how they lie.
template <int d>
struct Mesh_cells {
    static constexpr Index outside = -1;  ///< in the place of a neighbour: beyond the hull
    /// d + 1 vertex indices a cell, positively oriented: counter-clockwise in the plane; in space the first three turn left as seen from
    /// the fourth, so that det(b - a, c - a, e - a) > 0. Padded with `none` where all points are in a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> vertices;
    /// The cell beyond the facet opposite to each vertex; `outside` beyond the hull, and everywhere where all points are in a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> neighbours;
};

}  // namespace annulus
