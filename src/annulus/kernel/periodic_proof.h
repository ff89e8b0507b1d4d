// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <span>

namespace annulus::inline v1 {

/// Whether a table is the Delaunay triangulation of the points at these places and their translates, by the theorem of
/// docs/theory.md 8.3: facets are glued in pairs, with opposite orientations and to the same images; every vertex has a
/// cell, but where its place is NaN; the volumes of the cells add up to that of the lattice; every cell is positive,
/// and no opposite vertex is inside the sphere of a bi-cell, where cospherical points are decided by the perturbation.
/// All of it is exact, so that `true` is a proof. Writes `cospherical`. O(n). Needs rounding to nearest.
template <int d>
[[nodiscard]] bool is_proved_delaunay(Periodic_table<d>& table, const Lattice<d>& lattice,
                                      std::span<const Coordinates<d>> place);

extern template bool is_proved_delaunay(Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>);
extern template bool is_proved_delaunay(Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
