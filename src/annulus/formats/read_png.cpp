// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/formats/read_gray_image.h>

#include <png.h>

#include <algorithm>
#include <cmath>

namespace annulus {

namespace {

/// libpng's simplified interface, which keeps its jumps to itself.
class Png {
  public:
    explicit Png(const Source& source) : name_(source.name) {
        image_.version = PNG_IMAGE_VERSION;
        if (!png_image_begin_read_from_memory(&image_, source.content.data(), source.content.size())) fail();
    }
    ~Png() { png_image_free(&image_); }
    Png(const Png&) = delete;
    Png& operator=(const Png&) = delete;

    png_image& operator*() { return image_; }

    template <class Sample>
    void read(png_uint_32 format, std::vector<Sample>& to) {
        image_.format = format;
        to.resize(std::size_t{image_.width} * image_.height * PNG_IMAGE_SAMPLE_CHANNELS(format));
        const png_color paper{255, 255, 255};
        if (!png_image_finish_read(&image_, &paper, to.data(), 0, nullptr) || (image_.warning_or_error & PNG_IMAGE_ERROR) != 0) fail();
    }

  private:
    [[noreturn]] void fail() const {
        throw Input_error(Error_code::bad_input, name_, 0, "is no whole PNG: " + shown(image_.message), "a PNG image");
    }

    const std::string& name_;
    png_image image_{};
};

/// From light to what 16-bit files hold, as sRGB has it (IEC 61966-2-1), both from 0 to 65535.
std::uint16_t encoded(std::uint32_t light) {
    const double x = light / 65535.0, y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(y, 0.0, 1.0)));
}

}  // namespace

Gray_image read_png(const Source& source) {
    Png png(source);
    Gray_image image;
    set_size(image, (*png).width, (*png).height, source.name, 0);
    // A byte holds eight pixels at the best, and deflate makes 1032 of them one.
    if (image.width * image.height / (8 * 1032) > source.content.size())
        throw Input_error(Error_code::bad_input, source.name, 0,
                          "announces " + std::to_string(image.width) + " by " + std::to_string(image.height) + " pixels in " +
                              counted(source.content.size(), "byte"),
                          "a file that can hold them");
    if (((*png).format & PNG_FORMAT_FLAG_LINEAR) == 0) {
        std::vector<std::uint8_t> gray;
        png.read(PNG_FORMAT_GRAY, gray);
        image.value.assign(gray.begin(), gray.end());
        return image;
    }
    // Of 16 bits libpng hands out light alone, multiplied by opacity; values without a gamma are taken for sRGB as those of 8 bits are.
    (*png).flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    std::vector<std::uint16_t> light;
    png.read(PNG_FORMAT_LINEAR_Y_ALPHA, light);
    image.white = 65535;
    image.value.resize(light.size() / 2);
    for (std::size_t i = 0; i < image.value.size(); ++i)
        image.value[i] = encoded(std::min<std::uint32_t>(light[2 * i] + (65535u - light[2 * i + 1]), 65535u));
    return image;
}

}  // namespace annulus
