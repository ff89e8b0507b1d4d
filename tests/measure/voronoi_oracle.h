// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <gmpxx.h>

#include <cstddef>
#include <optional>
#include <span>

namespace annulus::testing {

/// Area or volume of the set of positions that are nearer to points[v] than to all others of these points: half planes
/// cut off a square, one after another, in rational numbers; in 3D the same in the plane of each facet. Uses no
/// triangulation and no circumcentre. None when it is unbounded. O(n^2) half planes in 3D.
[[nodiscard]] std::optional<mpq_class> exact_cell(std::span<const Coordinates<2>> points, std::size_t v);
[[nodiscard]] std::optional<mpq_class> exact_cell(std::span<const Coordinates<3>> points, std::size_t v);

}  // namespace annulus::testing
