// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/voronoi.h>

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::testing {

/// A side of a Voronoi cell, in rational numbers.
template <int d>
struct Exact_side {
    bool bounded = true;                                          ///< if not, it has an interior
    mpq_class square;                                             ///< of its measure
    std::array<mpq_class, static_cast<std::size_t>(d)> centroid;  ///< if the measure is above 0
};

template <int d>
struct Exact_polytope {
    std::vector<Exact_side<d>> sides;  ///< by the other points in order, then by the planes of the clip
    mpq_class volume;
    std::array<mpq_class, static_cast<std::size_t>(d)> centroid;  ///< if the volume is above 0
};

/// The sides of the set of positions that are nearer to points[v] than to all others of these points, and in the clip
/// if there is one: each plane is cut by all others, in rational numbers. Uses no triangulation and no circumcentre.
/// Volume and centroid are right if all sides are bounded. O(n^2) cuts.
template <int d>
[[nodiscard]] Exact_polytope<d> exact_polytope(std::span<const Coordinates<d>> points, std::size_t v,
                                               const Voronoi_clip<d>* clip = nullptr);

extern template Exact_polytope<2> exact_polytope<2>(std::span<const Coordinates<2>>, std::size_t,
                                                    const Voronoi_clip<2>*);
extern template Exact_polytope<3> exact_polytope<3>(std::span<const Coordinates<3>>, std::size_t,
                                                    const Voronoi_clip<3>*);

}  // namespace annulus::testing
