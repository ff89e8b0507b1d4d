// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <span>

namespace annulus::inline v1 {

/// The error of vertices of a periodic box that are images of one another, whatever call and whatever algorithm has
/// found that some are: it names all at one place, the lowest two of all that coincide among them. Vertex i is at
/// place[i], that of a representative, or nowhere at NaN. Precondition: some coincide. O(n log n).
template <int d>
[[nodiscard]] Error coinciding_images_error(const Lattice<d>& lattice, std::span<const Coordinates<d>> place);

extern template Error coinciding_images_error(const Lattice<2>&, std::span<const Coordinates<2>>);
extern template Error coinciding_images_error(const Lattice<3>&, std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
