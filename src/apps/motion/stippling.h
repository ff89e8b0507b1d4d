// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/image_density.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A grey picture, row by row from the top, each from left to right: 0 is black, `white` is white.
struct Gray_image {
    std::size_t width = 0, height = 0;
    std::uint16_t white = 255;
    std::vector<std::uint16_t> value;
};

/// A picture as dots: Voronoi stippling (Secord, Weighted Voronoi stippling, 2002). Ink is darkness, or brightness
/// where the picture is inverted.
class Stippling {
  public:
    /// Throws Error(bad_input) where there is no ink, and Error(usage) where the picture is invalid. O(pixels).
    Stippling(Gray_image image, bool inverted);

    [[nodiscard]] const Gray_image& image() const { return image_; }
    [[nodiscard]] std::size_t width() const { return image_.width; }
    [[nodiscard]] std::size_t height() const { return image_.height; }
    /// The area that the picture's ink covers, in pixels.
    [[nodiscard]] double area() const { return area_; }

    // Each call makes the density again: 24 bytes per pixel, O(pixels).

    /// The density of the first points and of the dots' sizes: the ink of each pixel, from 0 to `full()`.
    [[nodiscard]] Image_density ink() const;
    [[nodiscard]] double full() const { return image_.white; }
    /// The density of Lloyd's iterations: the square of the ink. In the limit the points are distributed in proportion
    /// to the square root of the density (Gersho's conjecture in 2D; Du, Faber and Gunzburger, Centroidal Voronoi
    /// tessellations, 1999, 6.4), so in proportion to the ink, as where they began.
    [[nodiscard]] Image_density density() const;

  private:
    [[nodiscard]] std::vector<std::uint32_t> amounts() const;

    Gray_image image_;
    bool inverted_;
    double area_;
};

/// The radius of equal discs that together have `area`.
[[nodiscard]] double disc_radius(double area, std::size_t discs);

}  // namespace annulus::inline v1
