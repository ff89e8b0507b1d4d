// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/degeneracy.h>
#include <apps/motion/cells_3.h>

#include <cstdint>
#include <span>

namespace annulus::inline v1 {

/// Shape of the cells of a mesh.
struct Mesh_quality {
    /// A cell is a sliver when one of its dihedral angles is below this many degrees, or above 180 less it.
    static constexpr double sliver_degrees = 10;

    Histogram dihedral = Histogram::linear(0, 180, 36);  ///< all six angles of every cell, in degrees
    std::uint64_t vertices = 0;                          ///< of these cells
    std::uint64_t boundary = 0;                          ///< of these, on a facet of only one of these cells
    std::uint64_t cells = 0;
    std::uint64_t slivers = 0;
};

/// The dihedral angles of the cells with a flag; flat cells without angles count as slivers. Linear.
[[nodiscard]] Mesh_quality mesh_quality(const Mesh_cells<3>& cells, std::span<const char> inside,
                                        std::span<const Coordinates<3>> position);

}  // namespace annulus::inline v1
