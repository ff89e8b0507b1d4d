// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/lattice.h>
#include <annulus/types.h>

namespace annulus::inline v1 {

/// The same for all images of a place, which is that of a representative: of those in the cell of the basis, widened by
/// what Lattice::in_basis rounds, the least.
template <int d>
[[nodiscard]] Coordinates<d> least_image(const Lattice<d>& lattice, const Coordinates<d>& place);

extern template Coordinates<2> least_image(const Lattice<2>&, const Coordinates<2>&);
extern template Coordinates<3> least_image(const Lattice<3>&, const Coordinates<3>&);

}  // namespace annulus::inline v1
