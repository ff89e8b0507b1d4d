// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// T1 transitions in 2D, ascending: i, j, k, l with i < j and k < l, where i and j were neighbours before, k and l are
/// since, and the triangles i j k and i j l became k l i and k l j.
using T1_transitions = std::vector<std::array<Index, 4>>;

/// Those of the triangles that came and went, three vertices each; infinite ones and padding are passed over. The lists
/// may be those of several changes, one after the other: a triangle that came and went by turns counts as it is after
/// the last one. Pairs that are made or broken otherwise, by several flips in one place or at the hull, are not listed.
/// O(k log k) for k triangles.
[[nodiscard]] T1_transitions t1_transitions(std::span<const Index> came, std::span<const Index> gone);

}  // namespace annulus::inline v1
