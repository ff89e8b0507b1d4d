// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <string>

namespace annulus::inline v1 {

/// Discs as a separate SVG document, one unit per pixel of the original picture: the rectangle [0, width] x [0,
/// height], y upwards. One radius for each point, or one for all. Black on white, or white on black. Coordinates are
/// off by no more than a twentieth of the mean radius, radii by a two hundredth. Linear.
[[nodiscard]] std::string svg_stipples(std::size_t width, std::size_t height, std::span<const Coordinates<2>> points,
                                       std::span<const double> radii, bool white_on_black);

}  // namespace annulus::inline v1
