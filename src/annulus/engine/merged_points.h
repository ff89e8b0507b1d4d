// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// An image of each representative, the same for all at one place of the torus. O(n).
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> least_images(const Lattice<d>& lattice, std::vector<Coordinates<d>> place);

/// The first ones of points that are images of one another, in their order, and which of these each point is.
template <int d>
struct Merged_points {
    std::vector<Coordinates<d>> distinct;
    std::vector<Index> vertex;
};

/// place[k] is the representative of points[k]: those at the same place of the torus are one. O(n log n).
template <int d>
[[nodiscard]] Merged_points<d> merged_points(const Lattice<d>& lattice, std::span<const Coordinates<d>> points,
                                             std::span<const Coordinates<d>> place);

extern template std::vector<Coordinates<2>> least_images(const Lattice<2>&, std::vector<Coordinates<2>>);
extern template std::vector<Coordinates<3>> least_images(const Lattice<3>&, std::vector<Coordinates<3>>);
extern template Merged_points<2> merged_points(const Lattice<2>&, std::span<const Coordinates<2>>,
                                               std::span<const Coordinates<2>>);
extern template Merged_points<3> merged_points(const Lattice<3>&, std::span<const Coordinates<3>>,
                                               std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
