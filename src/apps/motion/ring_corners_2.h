// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The error of a list of corners that is no polygon, with the corner at which that shows.
class Corner_error : public Error {
  public:
    Corner_error(std::size_t corner, const std::string& what) : Error(Error_code::bad_input, what), corner_(corner) {}
    /// Its index in the list, from 0.
    [[nodiscard]] std::size_t corner() const noexcept { return corner_; }

  private:
    std::size_t corner_;
};

/// A corner and its index in the input list.
struct Listed_corner {
    Coordinates<2> p;
    std::size_t index;
};

/// The largest coordinate in magnitude; 0 without corners.
[[nodiscard]] double largest_coordinate(std::span<const Coordinates<2>> corners);

/// The corners of a closed ring without those that repeat the one before, however often, across the end of the list
/// too: both coordinates differ by no more than 2^-60 times the largest coordinate. There is no -0 among them. Their
/// indices are counted from `first`.
///
/// Throws Corner_error: a coordinate that is not finite, a largest coordinate outside [1e-100, 1e100], fewer than 3
/// corners that are not on a line. Signs of orientations are exact. O(corners).
[[nodiscard]] std::vector<Listed_corner> ring_corners(std::span<const Coordinates<2>> corners, std::size_t first = 0);

}  // namespace annulus::inline v1
