// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cells_3.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The facets of a surface around each of its vertices.
class Surface_stars {
  public:
    /// Facets are triples of vertex numbers below n, consistently oriented. Linear.
    Surface_stars(std::span<const std::array<Index, 3>> facets, std::size_t n);

    /// Whether the facets around v are one closed fan: a disc with v inside. False where there are none, where the
    /// surface ends, or where sheets of it touch. Quadratic in the number of facets around v.
    [[nodiscard]] bool disc(Index v) const;
    /// The other corners of the facets around v, in their order; interior edges of a disc come twice.
    [[nodiscard]] std::span<const std::array<Index, 2>> around(Index v) const;

  private:
    std::vector<std::size_t> begin_;
    std::vector<std::array<Index, 2>> link_;  ///< edges opposite of a vertex, oriented like their facets
};

}  // namespace annulus::inline v1
