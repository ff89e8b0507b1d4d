// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/sign_evaluator.h>
#include <annulus/mesh/corner_table.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The paper's flips (3.1), in 2D, after v alone has moved in a Delaunay triangulation; x are the new positions. If v
/// is inside the hull and no triangle around it is inverted, edges that are not locally Delaunay are flipped until
/// there are none left, and `changed` receives the triangles that were flipped, each once or more. Otherwise returns
/// false, with nothing changed. Expected O(degree + flips).
[[nodiscard]] bool flip_after_move(Corner_table<2>& table, std::span<const Coordinates<2>> x, Index v,
                                   Sign_evaluator<2>& signs, std::vector<Cell_index>& changed);

}  // namespace annulus::inline v1
