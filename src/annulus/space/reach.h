// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/space/selling.h>

namespace annulus::inline v1 {

/// Twice the largest coordinates in a basis of a lattice, without sign, of the lattice's Voronoi cell at 0
/// (docs/theory.md 8.5). Computed in integers and rounded upward: at most 2^-49 above the true ones, relatively,
/// however thin the cell is. `superbase` is an obtuse one of `basis`, in combinations of it. O(1), some microseconds.
template <int d>
[[nodiscard]] Coordinates<d> reach_of(const Superbase<d>& superbase, const typename Box<d>::Vectors& basis);

extern template Coordinates<2> reach_of<2>(const Superbase<2>&, const Box<2>::Vectors&);
extern template Coordinates<3> reach_of<3>(const Superbase<3>&, const Box<3>::Vectors&);

}  // namespace annulus::inline v1
