// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/image_density.h>

#include <annulus/error.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1 {

Image_density::Image_density(std::size_t width, std::size_t height, std::span<const std::uint32_t> weight)
    : width_(width), height_(height) {
    if (width == 0 || width > most_width || height == 0 || weight.size() % width != 0 ||
        weight.size() / width != height)
        throw Error(Error_code::usage, "an image needs as many weights as pixels, at most 2^17 in a row");
    for (const std::uint32_t w : weight) {
        most_ = std::max(most_, w);
        total_ += w;
    }
    if (most_ == 0) throw Error(Error_code::usage, "an image of no weight is no density");
    if (most_ > most_weight) throw Error(Error_code::usage, "a weight of an image is 2^24 or more");
    const std::size_t columns = width + 2, rows = height + 2;
    std::vector<Node> node(columns * rows);
    for (std::size_t row = 0; row < rows; ++row) {
        // Weights begin with the top row, nodes with the lowest.
        const std::size_t from = height - std::clamp<std::size_t>(row, 1, height);
        Node* const at = &node[row * columns];
        for (std::size_t i = 0; i < columns; ++i) {
            at[i] = {weight[from * width + std::clamp<std::size_t>(i, 1, width) - 1], 0, 0};
            if (i == 0) continue;
            // The integrals of w and of s w over a step from v to w are (v + w) / 2 and (v + 2 w) / 6.
            const std::int64_t v = at[i - 1].weight, both = v + at[i].weight;
            at[i].sum = at[i - 1].sum + both;
            at[i].moment = at[i - 1].moment + 3 * static_cast<std::int64_t>(i - 1) * both + both + at[i].weight;
        }
    }
    node_ = std::make_shared<const std::vector<Node>>(std::move(node));
}

double Image_density::at(const Coordinates<2>& p) const {
    const double x = std::clamp(p[0], 0.0, static_cast<double>(width_)) + 0.5,
                 y = std::clamp(p[1], 0.0, static_cast<double>(height_)) + 0.5;
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const double s = x - static_cast<double>(i), t = y - static_cast<double>(j);
    const auto row = [&](std::size_t r) {
        return (1 - s) * static_cast<double>(node(i, r).weight) + s * static_cast<double>(node(i + 1, r).weight);
    };
    return (1 - t) * row(j) + t * row(j + 1);
}

}  // namespace annulus::inline v1
