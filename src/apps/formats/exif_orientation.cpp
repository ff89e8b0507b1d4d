// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/exif_orientation.h>

#include <utility>

namespace annulus::inline v1 {

namespace {

/// The whole number of `size` bytes at `at`, of either byte order; precondition: they are there.
std::uint64_t whole_at(std::string_view bytes, std::size_t at, std::size_t size, bool big) {
    std::uint64_t number = 0;
    for (std::size_t k = 0; k < size; ++k)
        number = 256 * number + static_cast<unsigned char>(bytes[at + (big ? k : size - 1 - k)]);
    return number;
}

}  // namespace

int exif_orientation(std::string_view segment) noexcept {
    constexpr std::string_view name("Exif\0\0", 6);
    if (!segment.starts_with(name)) return 0;
    // A TIFF: byte order, 42, where the list of entries is; its length; entries of 12 bytes, tag, type, count, value.
    const std::string_view tiff = segment.substr(name.size());
    if (tiff.size() < 8 || (tiff.substr(0, 2) != "II" && tiff.substr(0, 2) != "MM")) return 0;
    const bool big = tiff[0] == 'M';
    const std::uint64_t list = whole_at(tiff, 4, 4, big);
    if (whole_at(tiff, 2, 2, big) != 42 || list + 2 > tiff.size()) return 0;
    const std::uint64_t entries = whole_at(tiff, list, 2, big);
    for (std::uint64_t k = 0, at = list + 2; k < entries && at + 12 <= tiff.size(); ++k, at += 12) {
        if (whole_at(tiff, at, 2, big) != 274 || whole_at(tiff, at + 2, 2, big) != 3) continue;  // type 3: two bytes
        const std::uint64_t orientation = whole_at(tiff, at + 8, 2, big);
        return orientation <= 8 ? static_cast<int>(orientation) : 0;
    }
    return 0;
}

Gray_image turned(Gray_image image, int orientation) {
    if (orientation == 1) return image;
    // From 5 on columns are rows; then 2, 3, 6, 7: from right to left, 3, 4, 7, 8: from the bottom up.
    const bool exchanged = orientation >= 5;
    const bool leftwards = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7;
    const bool upwards = orientation == 3 || orientation == 4 || orientation == 7 || orientation == 8;
    Gray_image out;
    out.white = image.white;
    out.width = exchanged ? image.height : image.width;
    out.height = exchanged ? image.width : image.height;
    out.value.reserve(image.value.size());
    for (std::size_t j = 0; j < out.height; ++j)
        for (std::size_t i = 0; i < out.width; ++i) {
            std::size_t x = leftwards ? out.width - 1 - i : i, y = upwards ? out.height - 1 - j : j;
            if (exchanged) std::swap(x, y);
            out.value.push_back(image.value[y * image.width + x]);
        }
    return out;
}

}  // namespace annulus::inline v1
