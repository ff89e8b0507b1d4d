// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/report/svg_gray.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr std::size_t most_blocks = 120;
constexpr std::size_t levels = 16;

/// The levels of the blocks, row by row.
std::vector<std::size_t> block_levels(const Gray_image& image, std::size_t block, std::size_t columns,
                                      std::size_t rows) {
    std::vector<std::uint64_t> sum(columns * rows, 0), count(columns * rows, 0);
    for (std::size_t y = 0; y < image.height; ++y)
        for (std::size_t x = 0; x < image.width; ++x) {
            const std::size_t at = y / block * columns + x / block;
            sum[at] += image.value[y * image.width + x];
            ++count[at];
        }
    std::vector<std::size_t> level(columns * rows);
    for (std::size_t i = 0; i < level.size(); ++i)  // rounded to the nearest
        level[i] = static_cast<std::size_t>((2 * sum[i] * (levels - 1) + count[i] * image.white) /
                                            (2 * count[i] * image.white));
    return level;
}

std::string ratio(std::size_t part, std::size_t whole) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, static_cast<double>(part) / static_cast<double>(whole),
                                std::chars_format::fixed, 3)
                      .ptr};
}

}  // namespace

std::string svg_gray(const Gray_image& image, const std::string& label) {
    const std::size_t block = (std::max(image.width, image.height) + most_blocks - 1) / most_blocks;
    const std::size_t columns = (image.width + block - 1) / block, rows = (image.height + block - 1) / block;
    const std::vector<std::size_t> level = block_levels(image, block, columns, rows);
    std::array<std::string, levels> path;
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0, end = 0; x < columns; x = end) {
            const std::size_t here = level[y * columns + x];
            while (end < columns && level[y * columns + end] == here) ++end;
            const std::string run = std::to_string(end - x);
            path[here] += "M" + std::to_string(x) + " " + std::to_string(y) + "h" + run + "v1h-" + run + "z";
        }
    const std::string w = ratio(image.width, block), h = ratio(image.height, block);
    std::string out = "<svg class=\"gray\" viewBox=\"0 0 " + w + " " + h + "\" role=\"img\" aria-label=\"" +
                      escaped(label) + "\" shape-rendering=\"crispEdges\"><rect width=\"" + w + "\" height=\"" + h +
                      "\" fill=\"#fff\"/>";
    for (std::size_t k = 0; k + 1 < levels; ++k)
        if (!path[k].empty()) {
            const std::string digit(1, "0123456789abcdef"[k]);
            out += "<path fill=\"#" + digit + digit + digit + "\" d=\"" + path[k] + "\"/>";
        }
    return out + "</svg>";
}

}  // namespace annulus::inline v1
