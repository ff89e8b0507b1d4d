// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/stippling.h>

#include <annulus/arithmetic/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace annulus {

Stippling Stippling::of(const Gray_image& image, bool inverted) {
    std::vector<std::uint32_t> ink(image.value.begin(), image.value.end());
    if (!inverted)
        for (std::uint32_t& i : ink) i = image.white - i;
    if (std::all_of(ink.begin(), ink.end(), [](std::uint32_t i) { return i == 0; }))
        throw Error(Error_code::bad_input,
                    inverted ? "the picture is black all over" : "the picture is white all over");
    Image_density amount(image.width, image.height, ink);
    // Squares of more than 24 bits lose their last eight; none becomes 0.
    const std::uint32_t part = image.white < 4096 ? 1 : 256;
    for (std::uint32_t& i : ink) i = (i * i) / part + (i * i % part > 0 ? 1 : 0);
    for (std::uint32_t& i : ink) i = std::min(i, Image_density::most_weight);
    return {std::move(amount), static_cast<double>(image.white), Image_density(image.width, image.height, ink)};
}

double disc_radius(double area, std::size_t discs) {
    return std::sqrt(area / (std::numbers::pi * static_cast<double>(discs)));
}

}  // namespace annulus
