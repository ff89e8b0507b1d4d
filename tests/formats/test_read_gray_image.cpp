// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/read_gray_image.h>

#include <support/catch.h>

#include <png.h>
#include <zlib.h>

#include <cstdlib>
#include <string>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

using Values = std::vector<std::uint16_t>;

Gray_image read(const std::string& name, const std::string& content) {
    const Temporary_directory directory;
    return read_gray_image(directory.file(name, content));
}

void refuse(const std::string& name, const std::string& content, std::uint64_t line, const std::string& fault) {
    const Temporary_directory directory;
    expect_fault(directory.file(name, content), line, fault, [](const auto& file) { (void)read_gray_image(file); });
}

/// A PNG by libpng itself.
template <class Sample>
std::string png(png_uint_32 format, unsigned width, unsigned height, const std::vector<Sample>& samples) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = format;
    png_alloc_size_t size = 0;
    REQUIRE(png_image_write_to_memory(&image, nullptr, &size, 0, samples.data(), 0, nullptr));
    std::string out(size, '\0');
    REQUIRE(png_image_write_to_memory(&image, out.data(), &size, 0, samples.data(), 0, nullptr));
    out.resize(size);
    return out;
}

/// Bytes of a number, the highest first.
std::string four(std::uint32_t x) {
    return {static_cast<char>(x >> 24), static_cast<char>(x >> 16), static_cast<char>(x >> 8), static_cast<char>(x)};
}

std::string chunk(const std::string& name, const std::string& data) {
    const std::string body = name + data;
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
    return four(static_cast<std::uint32_t>(data.size())) + body + four(static_cast<std::uint32_t>(sum));
}

std::string png_by_hand(std::uint32_t width, std::uint32_t height, char depth, char colour, const std::string& rows) {
    std::string packed(compressBound(rows.size()), '\0');
    uLongf size = packed.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(rows.data()),
                     rows.size()) == Z_OK);
    packed.resize(size);
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", four(width) + four(height) + std::string{depth, colour, 0, 0, 0}) +
           chunk("IDAT", packed) + chunk("IEND", "");
}

}  // namespace

TEST_CASE("PBM and PGM of all kinds are read", "[formats][image]") {
    const std::string six("\0\1\2\3\4\11", 6);
    for (const std::string& content :
         {std::string("P2\n3 2\n9\n0 1 2\n3 4 9\n"), std::string("P2 # grey\n# by hand\n3\n2 9 0\n1 2 3 4 # five\n9"),
          "P5\n3 2\n9\n" + six, "P5 3 2 # a comment\n9\r" + six}) {
        CAPTURE(content);
        const Gray_image image = read("a.pgm", content);
        CHECK(image.width == 3);
        CHECK(image.height == 2);
        CHECK(image.white == 9);
        CHECK(image.value == Values{0, 1, 2, 3, 4, 9});
    }
    const Gray_image deep = read("a.PGM", std::string("P5 2 1 65535\n\1\2\377\376", 17));
    CHECK(deep.value == Values{258, 65534});
    CHECK(read("a.pgm.gz", gzip("P2 1 2 255 7 8")).value == Values{7, 8});
    CHECK(read("a.pgm", std::string("P5 1 1 255\n#", 12)).value == Values{'#'});
    for (const std::string& content : {std::string("P1 3 2 100\n1 1 0"), std::string("P4 3 2 \x80\xC0", 9)}) {
        CAPTURE(content);
        const Gray_image image = read("a.pbm", content);  // where 1 is black
        CHECK(image.width == 3);
        CHECK(image.white == 1);
        CHECK(image.value == Values{0, 1, 1, 0, 0, 1});
    }
}

TEST_CASE("PPM is read as luma", "[formats][image]") {
    const Values grey{54, 182, 18, 255};  // of pure red, green, blue, and white: 0.2126, 0.7152, 0.0722 times 255
    const Gray_image plain = read("a.ppm", "P3\n2 2\n255\n255 0 0 0 255 0 # two\n0 0 255 255 255 255\n");
    CHECK(plain.width == 2);
    CHECK(plain.height == 2);
    CHECK(plain.white == 255);
    CHECK(plain.value == grey);
    const std::string four("\377\0\0\0\377\0\0\0\377\377\377\377", 12);
    CHECK(read("a.PPM", "P6 4 1 255\n" + four).value == grey);
    CHECK(read("a.ppm.gz", gzip("P6 1 1 65535\n\1\2\1\2\1\2")).value == Values{258});
    CHECK(read("a.ppm", "P5\n1 1\n255\na").value == Values{'a'});
    CHECK(read("a.pnm", "P3 1 1 9 9 9 9").value == Values{9});
    refuse("a.ppm", "P6\n1 1\n255\nab", 3, "2 bytes");
    refuse("a.ppm", "P6\n2 1\n9\n\1\2\3\4\5\12", 0, "exceeds the image maxval of 9");
    refuse("a.ppm", "P6\n1 2\n9\n\1\2\3\4\5\12", 0, "exceeds the image maxval of 9");
    refuse("a.ppm", "P3\n1 1\n9\n1 2", 3, "4 bytes after its header");
}

TEST_CASE("PGM that is none is refused where it goes wrong", "[formats][image]") {
    const std::string no_whole = "is no whole picture: ";  // and what Netpbm says
    refuse("a.pgm", "", 1, "empty");
    refuse("a.pgm", "GIF89a", 1, no_whole);
    refuse("a.pgm", "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 1\nMAXVAL 255\nENDHDR\na", 1, "is a PAM picture");
    refuse("a.pgm", "P2\n3", 2, no_whole);
    refuse("a.pgm", "P2\n0 1\n9\n", 3, no_whole);
    refuse("a.pgm", "P2\n-1 1\n9\n", 2, no_whole);
    refuse("a.pgm", "P2\nx3 1\n9\n", 2, no_whole);
    refuse("a.pgm", "P2\n99999999999999999999 1\n9\n", 2, no_whole);
    refuse("a.pgm", "P2\n200000 1\n9\n", 3, "200000 by 1 pixels");
    refuse("a.pgm", "P2\n10000 10000\n9\n", 3, "10000 by 10000 pixels");
    refuse("a.pgm", "P2\n1 1\n0\n0", 3, no_whole);
    refuse("a.pgm", "P2\n1 1\n65536\n0", 3, no_whole);
    refuse("a.pgm", "P2\n2 2\n9\n1 2\n3", 3, "6 bytes after its header");
    refuse("a.pgm", "P2\n2 2\n9\n1  2\n3   ", 5, no_whole);
    refuse("a.pgm", "P2\n2 1\n9\n1\n10", 5, "10 exceeds the image maxval of 9");
    refuse("a.pgm", "P2\n2 1\n9\n1\n2\n3", 5, "goes on");
    refuse("a.pgm", "P2\n8000 8000\n9\n1 2\n", 3, "5 bytes after its header");
    refuse("a.pgm", "P5\n2 2\n9\n\1\2\3", 3, "3 bytes");
    refuse("a.pgm", "P5\n2 2\n9\n\1\2\3\4\5", 3, "5 bytes");
    refuse("a.pgm", "P5\n2 2\n9\n\1\2\3\12", 0, "10 exceeds the image maxval of 9");
    refuse("a.pgm", "P5\n8000 8000\n65535\n\1\2", 3, "2 bytes");
    refuse("a.gif", "P2 1 1 9 0", 0, "extension");
}

TEST_CASE("grey PNG keeps its values", "[formats][image]") {
    std::vector<std::uint8_t> all(256);
    Values expected(256);
    for (unsigned i = 0; i < 256; ++i)
        all[i] = static_cast<std::uint8_t>(i), expected[i] = static_cast<std::uint16_t>(i);
    const Gray_image image = read("a.png", png(PNG_FORMAT_GRAY, 16, 16, all));
    CHECK(image.width == 16);
    CHECK(image.height == 16);
    CHECK(image.white == 255);
    CHECK(image.value == expected);
    CHECK(read("a.Png.gz", gzip(png(PNG_FORMAT_GRAY, 16, 16, all))).value == expected);
    const std::string palette = chunk("PLTE", std::string("\12\12\12\377\377\377", 6)),
                      two = png_by_hand(2, 2, 8, 3, std::string("\0\0\1\0\1\0", 6));
    CHECK(read("a.png", two.substr(0, 33) + palette + two.substr(33)).value == Values{10, 255, 255, 10});
    // One bit a pixel: 10110000 010, rows of 11.
    CHECK(read("a.png", png_by_hand(11, 1, 1, 0, std::string("\0\xb0\x40", 3))).value ==
          Values{255, 0, 255, 255, 0, 0, 0, 0, 0, 255, 0});
}

TEST_CASE("pictures of more rows than libpng takes by itself", "[formats][image]") {
    const std::uint32_t height = 1000001;
    const Gray_image image = read("a.png", png_by_hand(1, height, 1, 0, std::string(2 * std::size_t{height}, '\0')));
    CHECK(image.height == height);
    CHECK(image.value == Values(height, 0));
    refuse("a.png", png_by_hand(2000000, 1, 1, 0, "x"), 0, "is 2000000 by 1 pixels");
}

TEST_CASE("colours become luma, and what is transparent is paper", "[formats][image]") {
    const Gray_image rgb = read(
        "a.png",
        png(PNG_FORMAT_RGB, 5, 1, std::vector<std::uint8_t>{0, 0, 0, 255, 255, 255, 90, 90, 90, 0, 255, 0, 0, 0, 255}));
    CHECK(rgb.value[0] == 0);
    CHECK(rgb.value[1] == 255);
    CHECK(rgb.value[2] == 90);
    CHECK(rgb.value[3] == 182);  // 0.7152 of white
    CHECK(rgb.value[4] == 18);   // 0.0722
    const Gray_image clear =
        read("a.png", png(PNG_FORMAT_GA, 4, 1, std::vector<std::uint8_t>{0, 0, 0, 255, 77, 255, 0, 51}));
    CHECK(clear.value == Values{255, 0, 77, 204});
}

TEST_CASE("PNG of 16 bits stays so", "[formats][image]") {
    std::string rows(1, '\0');
    Values expected;
    for (unsigned i = 0; i < 4096; ++i) {
        expected.push_back(static_cast<std::uint16_t>(16 * i + 5));
        rows += static_cast<char>(expected.back() >> 8);
        rows += static_cast<char>(expected.back());
    }
    const Gray_image image = read("a.png", png_by_hand(4096, 1, 16, 0, rows));
    CHECK(image.white == 65535);
    REQUIRE(image.value.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        CAPTURE(i);
        REQUIRE(image.value[i] == expected[i]);
    }
}

TEST_CASE("PNG that is none is refused in one line", "[formats][image]") {
    const std::string whole = png(PNG_FORMAT_GRAY, 16, 16, std::vector<std::uint8_t>(256, 100));
    CHECK_NOTHROW(read("a.png", whole));
    refuse("a.png", "no picture", 0, "no whole PNG");
    for (std::size_t size = 1; size + 12 < whole.size(); ++size) refuse("a.png", whole.substr(0, size), 0, "");
    for (std::size_t at = 0; at + 12 < whole.size();
         ++at) {  // a wrong bit: refused, or where it does not matter the same picture
        std::string broken = whole;
        broken[at] = static_cast<char>(broken[at] ^ 16);
        const Temporary_directory directory;
        try {
            const Gray_image image = read_gray_image(directory.file("a.png", broken));
            CHECK(image.value.size() == image.width * image.height);
        } catch (const Input_error& error) {
            CHECK(std::string(error.what()).find('\n') == std::string::npos);
        }
    }
    refuse("a.png", png_by_hand(0, 1, 8, 0, "\0"), 0, "no whole PNG");
    refuse("a.png", png_by_hand(200'000, 1, 8, 0, "\0"), 0, "pixels");
    refuse("a.png", png_by_hand(60'000, 60'000, 8, 0, "\0"), 0, "pixels");
    refuse("a.png", png_by_hand(8000, 8000, 1, 0, "\0"), 0, "announces");
    refuse("a.png", png_by_hand(64, 64, 8, 0, std::string(2000, '\0')), 0, "no whole PNG");
}
