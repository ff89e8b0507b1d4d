// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <vector>

namespace annulus::inline v1 {

/// The outlines of a union of polygons with disjoint interiors, counter-clockwise each, that meet in whole sides: what
/// is enclosed counter-clockwise, and holes clockwise. Corners nearer than 1e-9 of the extent of all are one, so that
/// rounding leaves no side between two parts. The parts themselves where the rest is not closed. O(n log n) in the
/// corners.
[[nodiscard]] std::vector<std::vector<Coordinates<2>>> joined_outlines(std::vector<std::vector<Coordinates<2>>> parts);

}  // namespace annulus::inline v1
