// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/stippling.h>

#include <string_view>

namespace annulus::inline v1 {

/// The orientation in a segment APP1 of a JPEG, 1 to 8 (tag 274 of Exif); 0 where the segment has none, or is none of
/// Exif's.
[[nodiscard]] int exif_orientation(std::string_view segment) noexcept;

/// The picture as it is looked at: stored rows and columns are mirrored and turned as the orientation says, 1 to 8, of
/// which 1 changes nothing. O(pixels), and another copy of them.
[[nodiscard]] Gray_image turned(Gray_image image, int orientation);

}  // namespace annulus::inline v1
