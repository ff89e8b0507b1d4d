// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A density given by the pixels of an image: at the middle of a pixel its weight, in between by bilinear
/// interpolation, and in the half pixel along the border constant outwards. It is continuous, and its integral over
/// the whole image is the sum of the weights.
///
/// The image is the rectangle [0, width] x [0, height]: unit of length one pixel, y upwards, the first row on top.
/// Immutable; copies share their pixels. 24 bytes a pixel.
class Image_density {
  public:
    static constexpr std::uint32_t most_weight = (1u << 24) - 1;
    static constexpr std::size_t most_width = std::size_t{1} << 17;

    /// `weight` row by row, from the top, each from left to right. Throws Error(usage) unless there are
    /// width * height of them, none above most_weight, not all 0, and width is at most most_width. O(pixels).
    Image_density(std::size_t width, std::size_t height, std::span<const std::uint32_t> weight);

    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t height() const { return height_; }
    /// The greatest weight, and the sum of all: the integral over the image.
    [[nodiscard]] std::uint32_t most() const { return most_; }
    [[nodiscard]] std::uint64_t total() const { return total_; }
    /// The density at p; outside the image that of the nearest point in it. O(1).
    [[nodiscard]] double at(const Coordinates<2>& p) const;

    /// A position where a weight is given, and the integrals of the density along its row from the first node on.
    /// Integers, so that differences are exact however small they are compared with the whole.
    struct Node {
        std::int64_t weight;
        std::int64_t sum;     ///< twice the integral of the density
        std::int64_t moment;  ///< six times that of density times distance from the first node
    };
    /// The node at (column - 1/2, row - 1/2), 0 <= column <= width + 1 and 0 <= row <= height + 1. Those at the ends
    /// repeat their neighbours' weights.
    [[nodiscard]] const Node& node(std::size_t column, std::size_t row) const {
        return (*node_)[row * (width_ + 2) + column];
    }

  private:
    std::size_t width_, height_;
    std::uint32_t most_ = 0;
    std::uint64_t total_ = 0;
    std::shared_ptr<const std::vector<Node>> node_;
};

}  // namespace annulus::inline v1
