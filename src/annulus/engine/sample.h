// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <cstddef>
#include <span>

namespace annulus {

/// What the filter stage says of some cells and their facets at positions to which the triangulation may not belong.
struct Sample {
    std::size_t cells = 0;     ///< looked at
    std::size_t inverted = 0;  ///< of these
    std::size_t facets = 0;
    std::size_t violated = 0;
    std::size_t unclear = 0;  ///< cells and facets of which it cannot tell
};

/// Adds a cell: its vertices in positive order, and the vertex beyond each of its facets. Facets of an inverted cell say nothing.
void add_cell(Sample& sample, std::span<const Coordinates<2>> x, const std::array<Index, 3>& v, const std::array<Index, 3>& beyond);
void add_cell(Sample& sample, std::span<const Coordinates<3>> x, const std::array<Index, 4>& v, const std::array<Index, 4>& beyond);

}  // namespace annulus
