// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// What the filter stage finds in some cells and their facets, at positions to which the triangulation may not
/// belong.
struct Sample {
    std::size_t cells = 0;     ///< tested
    std::size_t inverted = 0;  ///< of these
    std::size_t facets = 0;
    std::size_t violated = 0;
    std::size_t unclear = 0;  ///< cells and facets that the filter stage cannot decide
};

/// Tests one cell each of about `count` vertices, at x. The facets of an inverted cell are not counted. O(count).
template <int d>
[[nodiscard]] Sample sample_cells(const Corner_table<d>& t, std::span<const Coordinates<d>> x, std::size_t count);

extern template Sample sample_cells<2>(const Corner_table<2>&, std::span<const Coordinates<2>>, std::size_t);
extern template Sample sample_cells<3>(const Corner_table<3>&, std::span<const Coordinates<3>>, std::size_t);

}  // namespace annulus::inline v1
