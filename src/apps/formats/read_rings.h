// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/read_points.h>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace annulus::inline v1 {

/// The corners of rings, one ring after the other.
struct Ring_file {
    Point_file<2> corners;
    std::vector<std::size_t> begin;  ///< the first corner of each ring, ascending; the first is 0
};

/// Reads the rings of a polygon from a file of points. In formats of lines, .xyz and tables, a blank line between two
/// corners begins another ring; a comment does not. In other formats all corners are one ring. Throws as `read_points`.
[[nodiscard]] Ring_file read_rings(const std::filesystem::path& file);

}  // namespace annulus::inline v1
