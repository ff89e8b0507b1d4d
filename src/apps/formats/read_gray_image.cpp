// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/read_gray_image.h>

#include <apps/formats/file_bytes.h>
#include <apps/formats/format.h>

#include <algorithm>

namespace annulus::inline v1 {

bool is_gray_image(const std::filesystem::path& file) {
    return std::any_of(picture_formats.begin(), picture_formats.end(),
                       [&](Format format) { return has_extension_of(file, format); });
}

Gray_image read_gray_image(const std::filesystem::path& file) {
    const Format format = format_of(file, picture_formats);
    Source source = load_file(file, most_of_a_pipe);
    if (format == Format::png) return read_png(source);
    return format == Format::jpeg ? read_jpeg(source) : read_pnm(std::move(source));
}

std::uint16_t luma(std::uint64_t red, std::uint64_t green, std::uint64_t blue) {
    return static_cast<std::uint16_t>((2126 * red + 7152 * green + 722 * blue + 5000) / 10000);
}

void set_size(Gray_image& image, std::uint64_t width, std::uint64_t height, const std::string& name,
              std::uint64_t line) {
    constexpr std::uint64_t most = std::uint64_t{1} << 26;
    if (width == 0 || height == 0 || width > Image_density::most_width || height > most || width * height > most)
        throw Input_error(Error_code::bad_input, name, line,
                          "is " + std::to_string(width) + " by " + std::to_string(height) + " pixels",
                          "1 to 2^26 pixels, up to 2^17 in a row");
    image.width = width;
    image.height = height;
}

}  // namespace annulus::inline v1
