// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Laplace's weights of the natural neighbours of a point x (Belikov et al. 1997): the facet that its Voronoi cell
/// would have in common with theirs, over their distance, divided by the sum of these. They add up to 1, up to
/// rounding.
struct Laplace_weights {
    std::vector<std::size_t> point;  ///< by number
    std::vector<double> weight;
    /// Another point that is farther from x than this does not change the cell of x. Infinite, and without weights,
    /// where x is not in the interior of the hull.
    double reach_upper = std::numeric_limits<double>::infinity();
};

/// `near` are the points whose cells have a part of that of x, or more points, each once. A point at x has the weight 1
/// alone. The numbers from `own` on are images of x: they bound its cell, and have no weight. Precondition: rounding is
/// to nearest.
template <int d>
[[nodiscard]] Laplace_weights laplace_weights(std::span<const Coordinates<d>> near, const Coordinates<d>& x,
                                              std::size_t own = std::numeric_limits<std::size_t>::max());

extern template Laplace_weights laplace_weights<2>(std::span<const Coordinates<2>>, const Coordinates<2>&, std::size_t);
extern template Laplace_weights laplace_weights<3>(std::span<const Coordinates<3>>, const Coordinates<3>&, std::size_t);

}  // namespace annulus::inline v1
