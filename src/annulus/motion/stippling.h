// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/image_density.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// A grey picture, row by row from the top, each from left to right: 0 is black, `white` is white.
struct Gray_image {
    std::size_t width = 0, height = 0;
    std::uint16_t white = 255;
    std::vector<std::uint16_t> value;
};

/// A picture as dots: Voronoi stippling (Secord, Weighted Voronoi stippling, 2002). Ink is what is dark, or, inverted, what is bright.
struct Stippling {
    /// Ink of each pixel, from 0 to white. Its integral over white is the area to be covered.
    Image_density ink;
    double white;
    /// What Lloyd's iterations go by: the square of the ink. Where they end there are points in proportion to the square root of
    /// their density (Gersho's conjecture in the plane; Du, Faber and Gunzburger, Centroidal Voronoi tessellations, 1999, 6.4), so in
    /// proportion to the ink, as where they began.
    Image_density density;

    /// Throws Error(bad_input) where there is no ink, and what Image_density does. O(pixels).
    [[nodiscard]] static Stippling of(const Gray_image& image, bool inverted);
};

/// The radius of equal discs that together have `area`.
[[nodiscard]] double disc_radius(double area, std::size_t discs);

}  // namespace annulus
