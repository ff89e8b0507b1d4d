// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// An obtuse superbase of a lattice: d + 1 vectors with sum 0, any d of which are a basis, and no two at an acute
/// angle. Each row is a vector as a combination of the vectors of the box.
template <int d>
using Superbase = std::array<std::array<std::int64_t, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d + 1)>;

/// Selling's algorithm, in integers: while v . w > 0 for two of the vectors, replace v by -v and add to the others but
/// w what keeps the sum 0. Every step lowers the sum of the squared lengths, by 4 v . w in 2D and 2 v . w in 3D, and a
/// lattice has finitely many vectors up to a given length, so it ends. Before that the basis is reduced in pairs by
/// Euclid's algorithm, so that few steps are left, however skewed the box is. The shortest vectors come last.
///
/// Throws Error(usage) where the rows of `box` span no volume, and where a combination has a factor of 2^63 or more:
/// then the box is far too skewed for the grid.
template <int d>
[[nodiscard]] Superbase<d> obtuse_superbase(const typename Box<d>::Vectors& box);

extern template Superbase<2> obtuse_superbase<2>(const Box<2>::Vectors&);
extern template Superbase<3> obtuse_superbase<3>(const Box<3>::Vectors&);

}  // namespace annulus::inline v1
