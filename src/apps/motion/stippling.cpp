// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/stippling.h>

#include <annulus/error.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace annulus::inline v1 {

Stippling::Stippling(Gray_image image, bool inverted) : image_(std::move(image)), inverted_(inverted) {
    if (image_.width == 0 || image_.value.size() / image_.width != image_.height ||
        image_.value.size() % image_.width != 0)
        throw Error(Error_code::usage, "a picture needs as many values as pixels");
    std::uint64_t total = 0;
    for (const std::uint16_t value : image_.value) {
        if (value > image_.white) throw Error(Error_code::usage, "a value of a picture is above white");
        total += value;
    }
    if (!inverted) total = image_.value.size() * image_.white - total;
    if (total == 0)
        throw Error(Error_code::bad_input,
                    inverted ? "the picture is black all over" : "the picture is white all over");
    area_ = static_cast<double>(total) / full();
}

std::vector<std::uint32_t> Stippling::amounts() const {
    std::vector<std::uint32_t> amount(image_.value.begin(), image_.value.end());
    if (!inverted_)
        for (std::uint32_t& a : amount) a = image_.white - a;
    return amount;
}

Image_density Stippling::ink() const { return {image_.width, image_.height, amounts()}; }

Image_density Stippling::density() const {
    std::vector<std::uint32_t> amount = amounts();
    // Squares of more than 24 bits lose their last eight; none becomes 0.
    const std::uint32_t part = image_.white < 4096 ? 1 : 256;
    for (std::uint32_t& i : amount)
        i = std::min((i * i) / part + (i * i % part > 0 ? 1 : 0), Image_density::most_weight);
    return {image_.width, image_.height, amount};
}

double disc_radius(double area, std::size_t discs) {
    return std::sqrt(area / (std::numbers::pi * static_cast<double>(discs)));
}

}  // namespace annulus::inline v1
