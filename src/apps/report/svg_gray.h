// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/stippling.h>

#include <string>

namespace annulus::inline v1 {

/// A grey picture as one SVG element, for a page: in 16 levels, and in blocks of pixels, the means of which are shown,
/// so that there are at most 120 along the longer side. Linear.
[[nodiscard]] std::string svg_gray(const Gray_image& image, const std::string& label);

}  // namespace annulus::inline v1
