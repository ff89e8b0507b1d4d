// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/image_density.h>

namespace annulus::inline v1 {

/// An image laid over a rectangle: its lower left corner is at `lower`, and its pixels have these sides, which need not
/// be equal. Around the rectangle the density is that of the nearest point in it. Its integral over the rectangle is
/// the sum of the weights times the area of a pixel.
struct Placed_image {
    Image_density image;
    Coordinates<2> lower{}, pixel{1, 1};

    /// The place in the image.
    [[nodiscard]] Coordinates<2> in_image(const Coordinates<2>& p) const {
        return {(p[0] - lower[0]) / pixel[0], (p[1] - lower[1]) / pixel[1]};
    }
    /// The inverse.
    [[nodiscard]] Coordinates<2> from_image(const Coordinates<2>& p) const {
        return {lower[0] + p[0] * pixel[0], lower[1] + p[1] * pixel[1]};
    }
};

}  // namespace annulus::inline v1
