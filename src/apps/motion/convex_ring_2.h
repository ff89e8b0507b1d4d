// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/ring_corners_2.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The corners of the convex polygon that a list of points goes around once, counter-clockwise, the lexicographically
/// smallest first: the same bits wherever the list begins, whichever way round it goes, and whether or not it repeats
/// its first corner at the end. Signs of orientations are exact. What is dropped:
/// - a corner that repeats the one before, however often, across the end of the list too: both coordinates differ by
///   no more than 2^-60 times the largest coordinate;
/// - a corner between its neighbours on one line;
/// - a corner inside the line of its neighbours, by no more than 4e-15 times the largest coordinate, as rounding
///   leaves corners on edges.
/// Every other corner is kept, however flat.
///
/// Throws Corner_error: a coordinate that is not finite, a largest coordinate outside [1e-100, 1e100], fewer than 3
/// corners that are not on a line, a list that goes back on itself, turns both ways, or goes around more than once.
/// O(corners).
[[nodiscard]] std::vector<Coordinates<2>> convex_ring(std::span<const Coordinates<2>> corners);

}  // namespace annulus::inline v1
