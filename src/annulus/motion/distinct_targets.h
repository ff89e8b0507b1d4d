// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <cstddef>
#include <span>

namespace annulus {

/// Two vertices with one target would collide: they rest, and so do those that are then in the way of one that rests.
/// Positions differ. `kept` grows by how many. O(n) expected while no two targets are equal, which is nearly always.
void rest_where_equal(std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target, std::size_t& kept);

}  // namespace annulus
