// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/exif_orientation.h>
#include <apps/formats/read_gray_image.h>

#include <support/catch.h>

#include <cstdio>  // which jpeglib.h needs

#include <jpeglib.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

using Values = std::vector<std::uint16_t>;

Gray_image read_jpeg_file(const std::string& content, const std::string& name = "a.jpg") {
    const Temporary_directory directory;
    return read_gray_image(directory.file(name, content));
}

void refuse_jpeg(const std::string& content, const std::string& fault) {
    const Temporary_directory directory;
    expect_fault(directory.file("a.jpg", content), 0, fault, [](const auto& file) { (void)read_gray_image(file); });
}

/// How a JPEG is written.
struct Writing {
    J_COLOR_SPACE given = JCS_GRAYSCALE, stored = JCS_GRAYSCALE;
    int components = 1;
    std::vector<jpeg_scan_info> scans = {};  ///< none: one for all
    std::string segment = {};                ///< APP1
};

/// A JPEG of the best quality by libjpeg itself. Squares of 8 by 8 equal values are exact in it.
std::string jpeg(unsigned width, unsigned height, const std::vector<std::uint8_t>& samples, const Writing& how = {}) {
    jpeg_compress_struct out;
    jpeg_error_mgr errors;
    out.err = jpeg_std_error(&errors);
    jpeg_CreateCompress(&out, JPEG_LIB_VERSION, sizeof out);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&out, &bytes, &size);
    out.image_width = width;
    out.image_height = height;
    out.input_components = how.components;
    out.in_color_space = how.given;
    jpeg_set_defaults(&out);
    jpeg_set_colorspace(&out, how.stored);
    jpeg_set_quality(&out, 100, TRUE);
    for (int k = 0; k < out.num_components; ++k) out.comp_info[k].h_samp_factor = out.comp_info[k].v_samp_factor = 1;
    if (!how.scans.empty()) {
        out.scan_info = how.scans.data();
        out.num_scans = static_cast<int>(how.scans.size());
    }
    jpeg_start_compress(&out, TRUE);
    if (!how.segment.empty())
        jpeg_write_marker(&out, JPEG_APP0 + 1, reinterpret_cast<const JOCTET*>(how.segment.data()),
                          static_cast<unsigned>(how.segment.size()));
    std::vector<std::uint8_t> row(samples);  // libjpeg takes no constant ones
    while (out.next_scanline < height) {
        JSAMPROW rows[] = {row.data() + std::size_t{out.next_scanline} * width * static_cast<unsigned>(how.components)};
        jpeg_write_scanlines(&out, rows, 1);
    }
    jpeg_finish_compress(&out);
    jpeg_destroy_compress(&out);
    std::string content(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return content;
}

std::string gray_jpeg(unsigned width, unsigned height, const Writing& how = {}) {
    std::vector<std::uint8_t> samples;
    for (unsigned j = 0; j < height; ++j)
        for (unsigned i = 0; i < width; ++i) samples.push_back(static_cast<std::uint8_t>((7 * i + 11 * j) % 256));
    return jpeg(width, height, samples, how);
}

/// The file with a part of the header of its frame replaced: `at` bytes behind the marker.
std::string with_frame(std::string content, std::size_t at, const std::string& bytes) {
    const std::size_t frame = content.find("\xff\xc0");
    REQUIRE(frame != std::string::npos);
    return content.replace(frame + at, bytes.size(), bytes);
}

/// Exif's segment with an entry before that of the orientation.
std::string exif(char orientation, bool big) {
    const auto number = [&](unsigned x, std::size_t size) {
        std::string bytes;
        for (std::size_t k = 0; k < size; ++k) bytes += static_cast<char>(x >> (8 * (big ? size - 1 - k : k)));
        return bytes;
    };
    const auto entry = [&](unsigned tag, unsigned value) {
        return number(tag, 2) + number(3, 2) + number(1, 4) + number(value, 2) + number(0, 2);
    };
    return std::string("Exif\0\0", 6) + (big ? "MM" : "II") + number(42, 2) + number(8, 4) + number(2, 2) +
           entry(256, 24) + entry(274, static_cast<unsigned char>(orientation)) + number(0, 4);
}

}  // namespace

TEST_CASE("grey JPEG is read, whatever its size", "[formats][image]") {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {17u, 3u}, {16u, 64u}}) {
        CAPTURE(width, height);
        const Gray_image image = read_jpeg_file(gray_jpeg(width, height));
        REQUIRE(image.width == width);
        REQUIRE(image.height == height);
        REQUIRE(image.white == 255);
        REQUIRE(image.value.size() == width * height);
        for (unsigned j = 0; j < height; ++j)
            for (unsigned i = 0; i < width; ++i)
                REQUIRE(std::abs(image.value[j * width + i] - static_cast<int>((7 * i + 11 * j) % 256)) <= 2);
    }
    const std::string content = jpeg(8, 8, std::vector<std::uint8_t>(64, 77));
    const Values even(64, 77);
    for (const std::string name : {"a.jpg", "a.JPG", "a.jpeg"}) CHECK(read_jpeg_file(content, name).value == even);
    CHECK(read_jpeg_file(gzip(content), "a.jpg.gz").value == even);
    CHECK(read_jpeg_file(content + "what a camera appends").value == even);
}

TEST_CASE("progressive JPEG has the same values", "[formats][image]") {
    const Writing how{
        .scans = {{1, {0}, 0, 0, 0, 1}, {1, {0}, 1, 63, 0, 1}, {1, {0}, 0, 0, 1, 0}, {1, {0}, 1, 63, 1, 0}}};
    const std::string progressive = gray_jpeg(40, 23, how);
    CHECK(progressive.find("\xff\xc2") != std::string::npos);
    CHECK(read_jpeg_file(progressive).value == read_jpeg_file(gray_jpeg(40, 23)).value);
}

TEST_CASE("colours of a JPEG become luma", "[formats][image]") {
    std::vector<std::uint8_t> samples;
    for (const auto& colour : {std::array<std::uint8_t, 3>{0, 0, 255}, {0, 255, 0}, {90, 90, 90}, {255, 255, 255}})
        for (int k = 0; k < 64; ++k) samples.insert(samples.end(), colour.begin(), colour.end());
    const auto middles = [&](J_COLOR_SPACE stored) {  // of four squares, one below the other
        const Gray_image image =
            read_jpeg_file(jpeg(8, 32, samples, {.given = JCS_RGB, .stored = stored, .components = 3}));
        return std::vector<int>{image.value[4 * 8 + 4], image.value[12 * 8 + 4], image.value[20 * 8 + 4],
                                image.value[28 * 8 + 4]};
    };
    CHECK(middles(JCS_RGB) == std::vector<int>{18, 182, 90, 255});  // 0.0722 and 0.7152 of white
    const std::vector<int> rounded = middles(JCS_YCbCr);
    CHECK(std::abs(rounded[0] - 18) <= 2);
    CHECK(std::abs(rounded[1] - 182) <= 2);
    CHECK(rounded[2] == 90);
    CHECK(rounded[3] == 255);
}

TEST_CASE("JPEG is turned as Exif says", "[formats][image]") {
    std::vector<std::uint8_t> samples;
    for (unsigned j = 0; j < 16; ++j)
        for (unsigned i = 0; i < 24; ++i) samples.push_back(static_cast<std::uint8_t>(3 * (j / 8) + i / 8 + 1));
    // Which square is where, row by row, by the text of the standard: the first row is at the top, the top, ..
    const std::vector<std::vector<std::string>> seen{{"123", "456"},     {"321", "654"},     {"654", "321"},
                                                     {"456", "123"},     {"14", "25", "36"}, {"41", "52", "63"},
                                                     {"63", "52", "41"}, {"36", "25", "14"}};
    for (const bool big : {false, true})
        for (std::size_t k = 0; k < 10; ++k) {
            CAPTURE(big, k);
            const Gray_image image =
                read_jpeg_file(jpeg(24, 16, samples, {.segment = exif(static_cast<char>(k), big)}));
            const auto& rows = seen[k < 1 || k > 8 ? 0 : k - 1];  // others than 1 to 8 count as none
            REQUIRE(image.width == 8 * rows[0].size());
            REQUIRE(image.height == 8 * rows.size());
            for (std::size_t j = 0; j < image.height; ++j)
                for (std::size_t i = 0; i < image.width; ++i)
                    REQUIRE(image.value[j * image.width + i] == rows[j / 8][i / 8] - '0');
        }
    const std::string whole = exif(6, true);
    CHECK(exif_orientation(whole) == 6);
    for (std::size_t size = 0; size < 40; ++size) CHECK(exif_orientation(whole.substr(0, size)) == 0);
    CHECK(exif_orientation("http://ns.adobe.com/xap/1.0/") == 0);
    std::string far = whole;
    far[10] = '\xff';  // where the list is
    CHECK(exif_orientation(far) == 0);
}

TEST_CASE("JPEG that is none, or cut, or damaged is refused in one line", "[formats][image]") {
    refuse_jpeg("no picture", "no whole JPEG");
    const Writing coloured{.given = JCS_RGB, .stored = JCS_YCbCr, .components = 3};
    const Writing progressive{.scans = {{1, {0}, 0, 0, 0, 0}, {1, {0}, 1, 63, 0, 0}}};
    for (const std::string& whole : {gray_jpeg(16, 24), gray_jpeg(16, 24, progressive),
                                     jpeg(16, 16, std::vector<std::uint8_t>(768, 100), coloured)}) {
        CHECK_NOTHROW(read_jpeg_file(whole));
        for (std::size_t size = 1; size < whole.size(); ++size) refuse_jpeg(whole.substr(0, size), "");
        for (std::size_t at = 0; at < whole.size(); at += 3) {
            std::string broken = whole;
            broken[at] = static_cast<char>(broken[at] ^ 16);
            try {
                const Gray_image image = read_jpeg_file(broken);
                CHECK(image.value.size() == image.width * image.height);
            } catch (const Input_error& error) {
                CHECK(std::string(error.what()).find('\n') == std::string::npos);
            }
        }
    }
    // Its data are cut short, and the end is marked.
    const std::string whole = gray_jpeg(64, 64);
    refuse_jpeg(whole.substr(0, whole.size() - 300) + "\xff\xd9", "no whole JPEG");
}

TEST_CASE("JPEG of other kinds and sizes is refused", "[formats][image]") {
    const std::string whole = gray_jpeg(16, 16);
    refuse_jpeg(jpeg(8, 8, std::vector<std::uint8_t>(256, 9), {.given = JCS_CMYK, .stored = JCS_CMYK, .components = 4}),
                "CMYK");
    refuse_jpeg(jpeg(8, 8, std::vector<std::uint8_t>(256, 9), {.given = JCS_CMYK, .stored = JCS_YCCK, .components = 4}),
                "CMYK");
    refuse_jpeg(
        jpeg(8, 8, std::vector<std::uint8_t>(128, 9), {.given = JCS_UNKNOWN, .stored = JCS_UNKNOWN, .components = 2}),
        "2 components");
    refuse_jpeg(with_frame(whole, 1, "\xc9"), "arithmetic");
    refuse_jpeg(with_frame(whole, 4, "\x0c"), "no whole JPEG");                  // 12 bits
    refuse_jpeg(with_frame(whole, 5, std::string("\0\0", 2)), "no whole JPEG");  // no rows
    refuse_jpeg(with_frame(whole, 5, "\xea\x60\xea\x60"), "is 60000 by 60000 pixels");
    refuse_jpeg(with_frame(whole, 5, "\x1f\x40\x1f\x40"), "announces 8000 by 8000 pixels");
    // A bit of each coefficient in each scan.
    std::vector<jpeg_scan_info> scans{{1, {0}, 0, 0, 0, 0}};
    for (int bit = 8; bit >= 0; --bit)
        for (int k = 1; k < 64; ++k) scans.push_back({1, {0}, k, k, bit == 8 ? 0 : bit + 1, bit});
    refuse_jpeg(gray_jpeg(16, 16, {.scans = scans}), "more than 500 scans");
}
