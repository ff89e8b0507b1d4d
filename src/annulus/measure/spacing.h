// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>

#include <span>

namespace annulus::inline v1 {

/// Root of the content of the hull per vertex, in the unit of the points: a unit for thresholds, computed in doubles.
/// Precondition: there are cells, and x has the positions of all vertices and no others. O(n).
[[nodiscard]] double mean_spacing(const Corner_table<2>& t, std::span<const Coordinates<2>> x);
[[nodiscard]] double mean_spacing(const Corner_table<3>& t, std::span<const Coordinates<3>> x);

/// The distance of doubles at the largest coordinate. O(n).
[[nodiscard]] double resolution(std::span<const Coordinates<2>> x);
[[nodiscard]] double resolution(std::span<const Coordinates<3>> x);

}  // namespace annulus::inline v1
