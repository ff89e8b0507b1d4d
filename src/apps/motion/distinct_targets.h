// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// Two vertices with the same target would be duplicate points: both rest, and so does every vertex whose target is the
/// position of one that rests. Precondition: positions differ. Adds the number of these vertices to `kept`. O(n)
/// expected while no two targets are equal, which is nearly always so.
void rest_where_equal(std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target, std::size_t& kept);

}  // namespace annulus::inline v1
