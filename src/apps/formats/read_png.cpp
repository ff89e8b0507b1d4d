// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/read_gray_image.h>

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>

namespace annulus::inline v1 {

namespace {

/// libpng reports errors by longjmp: `header` and `pixels` construct no object between setjmp and their end.
class Png {
  public:
    explicit Png(const Source& source) : rest_(source.content) {
        png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, on_warning);
        info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
        png_set_read_fn(png_, this, on_read);
    }
    ~Png() { png_destroy_read_struct(&png_, &info_, nullptr); }
    Png(const Png&) = delete;
    Png& operator=(const Png&) = delete;

    /// Reads up to the pixels, which are grey or RGB, with or without alpha, of 8 or 16 bits.
    bool header() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // set_size has our limits
        png_read_info(png_, info_);
        packed_bits = std::uint64_t{png_get_bit_depth(png_, info_)} * png_get_channels(png_, info_);
        png_set_expand(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        width = png_get_image_width(png_, info_);
        height = png_get_image_height(png_, info_);
        channels = png_get_channels(png_, info_);
        bytes = png_get_bit_depth(png_, info_) / 8u;
        return true;
    }

    bool pixels(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

    std::uint64_t packed_bits = 0;  ///< bits of a pixel before deflation
    std::size_t width = 0, height = 0, channels = 0, bytes = 0;
    char message[80] = {};

  private:
    static void on_error(png_structp png, png_const_charp text) {
        char* const message = static_cast<Png*>(png_get_error_ptr(png))->message;
        std::strncpy(message, text, sizeof Png::message - 1);
        png_longjmp(png, 1);
    }
    static void on_warning(png_structp, png_const_charp) {}
    static void on_read(png_structp png, png_bytep to, std::size_t size) {
        std::string_view& rest = static_cast<Png*>(png_get_io_ptr(png))->rest_;
        if (size > rest.size()) png_error(png, "the file ends");
        std::memcpy(to, rest.data(), size);
        rest.remove_prefix(size);
    }

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::string_view rest_;
};

/// The value of the pixel at `at`, blended with white.
std::uint16_t gray(const std::uint8_t* at, std::size_t channels, std::size_t bytes) {
    const auto sample = [&](std::size_t k) -> std::uint64_t {
        return bytes == 1 ? at[k] : std::uint64_t{256} * at[2 * k] + at[2 * k + 1];
    };
    const std::uint64_t white = bytes == 1 ? 255 : 65535;
    const std::uint64_t value = channels < 3 ? sample(0) : luma(sample(0), sample(1), sample(2));
    if (channels % 2 == 1) return static_cast<std::uint16_t>(value);
    const std::uint64_t opacity = sample(channels - 1);
    return static_cast<std::uint16_t>((value * opacity + white * (white - opacity) + white / 2) / white);
}

}  // namespace

Gray_image read_png(const Source& source) {
    Png png(source);
    const auto fail = [&](std::string fault, std::string expected) {
        throw Input_error(Error_code::bad_input, source.name, 0, std::move(fault), std::move(expected));
    };
    if (!png.header()) fail("is no whole PNG: " + shown(png.message), "a PNG image");
    Gray_image image;
    set_size(image, png.width, png.height, source.name, 0);
    // Deflate packs at most 1032 bytes into one.
    if (png.width * png.height * png.packed_bits / (8 * 1032) > source.content.size())
        fail("announces " + std::to_string(png.width) + " by " + std::to_string(png.height) + " pixels in " +
                 counted(source.content.size(), "byte"),
             "a file that can hold them");
    const std::size_t pixel = png.channels * png.bytes;
    std::vector<std::uint8_t> samples(png.width * png.height * pixel);
    std::vector<png_bytep> rows(png.height);
    for (std::size_t j = 0; j < png.height; ++j) rows[j] = samples.data() + j * png.width * pixel;
    if (!png.pixels(rows.data())) fail("is no whole PNG: " + shown(png.message), "a PNG image");
    image.white = png.bytes == 1 ? 255 : 65535;
    image.value.reserve(png.width * png.height);
    for (std::size_t i = 0; i < png.width * png.height; ++i)
        image.value.push_back(gray(samples.data() + i * pixel, png.channels, png.bytes));
    return image;
}

}  // namespace annulus::inline v1
