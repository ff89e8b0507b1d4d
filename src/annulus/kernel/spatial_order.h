// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <span>
#include <vector>

namespace annulus {

/// Puts vertices, given as indices of points x, in the order in which Builder inserts them.
///
/// A biased randomized insertion order (Amenta, Choi, Rote, SoCG 2003): rounds, each eight times as large as the one
/// before, whose members are told by a hash of the index; within a round along a Hilbert curve. Without rounds points
/// on few lines or spheres would make cavities that grow with n. Points whose keys on the curve are equal are sorted
/// again in a box of their own, so clusters of any scale are resolved; points at one place keep the order of
/// `vertices`. The order depends on indices and positions alone. Expected O(n).
template <int d>
void spatial_order(std::span<const Coordinates<d>> x, std::vector<Index>& vertices);

extern template void spatial_order<2>(std::span<const Coordinates<2>>, std::vector<Index>&);
extern template void spatial_order<3>(std::span<const Coordinates<3>>, std::vector<Index>&);

}  // namespace annulus
