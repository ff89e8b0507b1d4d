// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/read_motion.h>
#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

using Points_3 = std::vector<Coordinates<3>>;
using Numbers = std::vector<std::uint64_t>;

/// The bytes of a number, the least significant first, or the other way round.
template <class T>
std::string bytes_of(T value, bool big = false) {
    const auto array = std::bit_cast<std::array<char, sizeof(T)>>(value);
    std::string bytes(array.begin(), array.end());
    if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// An array as numpy.save writes it.
std::string npy(const std::string& type, const std::string& shape, const std::string& data, char version = 1,
                const std::string& order = "False") {
    std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
    header += std::string(63 - (header.size() + 10) % 64, ' ') + "\n";
    const auto size = static_cast<std::uint32_t>(header.size());
    const std::string length = version == 1 ? bytes_of(static_cast<std::uint16_t>(size)) : bytes_of(size);
    return std::string("\x93NUMPY") + version + '\0' + length + header + data;
}

template <class T>
std::string numbers(const std::vector<T>& values, bool big = false) {
    std::string data;
    for (const T value : values) data += bytes_of(value, big);
    return data;
}

const std::vector<double> two_frames{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};

Recorded_motion accept(const std::string& content) {
    const Temporary_directory directory;
    return read_motion(directory.file("a.npy", content));
}

void refuse(const std::string& content, std::uint64_t line, const std::string& fault,
            Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file("a.npy", content), line, fault, [](const auto& file) { (void)read_motion(file); }, code);
}

}  // namespace

TEST_CASE("npy: frames x points x d, in all types of 4 and 8 bytes and both orders of bytes", "[io][npy]") {
    const std::vector<float> floats(two_frames.begin(), two_frames.end());
    const std::vector<std::int32_t> ints(two_frames.begin(), two_frames.end());
    const std::vector<std::int64_t> longs(two_frames.begin(), two_frames.end());
    for (const auto& [type, data] : std::vector<std::pair<std::string, std::string>>{
             {"<f8", numbers(two_frames)},
             {">f8", numbers(two_frames, true)},
             {"<f4", numbers(floats)},
             {">f4", numbers(floats, true)},
             {"<i4", numbers(ints)},
             {">i8", numbers(longs, true)},
             {"<u4", numbers(ints)},
             {"<u8", numbers(longs)},
         }) {
        INFO(type);
        const Recorded_motion space = accept(npy(type, "(2, 2, 3)", data));
        REQUIRE(space.frames.size() == 2);
        CHECK(space.has_z);
        CHECK(space.frames[0].position == Points_3{{0, 1, 2}, {3, 4, 5}});
        CHECK(space.frames[1].position == Points_3{{6, 7, 8}, {9, 10, 11}});
        CHECK(space.frames[1].number == 1);
        CHECK(space.frames[1].id == Numbers{0, 1});
        CHECK(space.frames[1].line == Numbers{3, 4});
        const Recorded_motion plane = accept(npy(type, "(2, 3, 2)", data));
        CHECK_FALSE(plane.has_z);
        CHECK(plane.frames[1].position == Points_3{{6, 7, 0}, {8, 9, 0}, {10, 11, 0}});
        CHECK(accept(npy(type, "(6, 2)", data)).frames.size() == 1);
    }
    for (const char version : {char{1}, char{2}, char{3}})
        CHECK(accept(npy("<f8", "(2, 2, 3)", numbers(two_frames), version)).frames.size() == 2);
    CHECK(accept(npy("<i4", "(1, 2)", numbers(std::vector<std::int32_t>{-5, 7}))).frames[0].position ==
          Points_3{{-5, 7, 0}});
    CHECK(accept(gzip(npy("<f8", "(2, 2, 3)", numbers(two_frames)))).frames.size() == 2);
    const Temporary_directory directory;
    CHECK(read_points<3>(directory.file("a.npy", npy("<f8", "(4, 3)", numbers(two_frames)))).points.size() == 4);
    const auto points = read_points<2>(directory.file("b.npy", npy("<f8", "(1, 6, 2)", numbers(two_frames))));
    CHECK(points.columns == Taken_columns{{"x", "[:, :, 0]"}, {"y", "[:, :, 1]"}});
    CHECK(points.lines == Numbers{1, 2, 3, 4, 5, 6});
    expect_fault(directory.file("c.npy", npy("<f8", "(2, 3, 2)", numbers(two_frames))), 1, "has 2 frames",
                 [](const auto& file) { (void)read_points<2>(file); });
    // More than a block.
    const std::vector<double> many(60'000, 0.5);
    CHECK(accept(npy("<f8", "(10, 3000, 2)", numbers(many))).frames[9].position.size() == 3000);
}

TEST_CASE("npy: a point that is NaN is absent from its frame", "[io][npy]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Recorded_motion motion =
        accept(npy("<f8", "(3, 2, 2)", numbers<double>({0, 0, 1, 1, nan, nan, 2, 2, nan, nan, nan, nan})));
    REQUIRE(motion.frames.size() == 3);
    CHECK(motion.frames[1].id == Numbers{1});
    CHECK(motion.frames[1].line == Numbers{4});
    CHECK(motion.frames[2].id.empty());
    refuse(npy("<f8", "(1, 2, 2)", numbers<double>({0, 0, 1, nan})), 2, "y is nan", Error_code::not_finite);
    refuse(npy("<f8", "(1, 2, 2)", numbers<double>({0, 0, -INFINITY, 0})), 2, "x is infinite", Error_code::not_finite);
    const Temporary_directory directory;
    expect_fault(
        directory.file("a.npy", npy("<f8", "(1, 2)", numbers<double>({nan, nan}))), 1, "x is nan",
        [](const auto& file) { (void)read_points<2>(file); }, Error_code::not_finite);
}

TEST_CASE("npy: other arrays are refused for their own reason", "[io][npy]") {
    const std::string data = numbers(two_frames), good = npy("<f8", "(2, 2, 3)", data);
    for (const auto& [content, fault] : std::vector<std::pair<std::string, std::string>>{
             {"", "is empty"},
             {"0 0\n1 1\n", "is no array of NumPy"},
             {"\x93NUMPX\x01", "is no array of NumPy"},
             {good.substr(0, 7), "is no array of NumPy"},
             {good.substr(0, 9), "is cut off within its header"},
             {good.substr(0, 40), "is cut off within its header"},
             {npy("<f8", "(2, 2, 3)", data, 4), "is of version 4"},
             {std::string("\x93NUMPY\x02\0\0\0\0\xff", 12), "has a header of 4278190080 bytes"},
             {npy("<f8", "(2, 2, 3)", data, 1, "True"), "is in Fortran's order"},
             {npy("<f8", "(2, 2, 3)", data, 1, "Yes"), "has neither True nor False"},
             {npy("<f2", "(2, 2, 3)", data), "has elements of type '<f2'"},
             {npy("<c8", "(2, 2, 3)", data), "has elements of type '<c8'"},
             {npy("|u1", "(2, 2, 3)", data), "has elements of type '|u1'"},
             {npy("<f8", "(12,)", data), "has the shape (12)"},
             {npy("<f8", "()", data), "has the shape ()"},
             {npy("<f8", "(3, 4)", data), "has the shape (3, 4)"},
             {npy("<f8", "(1, 2, 2, 3)", data), "has the shape (1, 2, 2, 3)"},
             {npy("<f8", "(2, 0, 3)", ""), "has no points"},
             {npy("<f8", "(0, 2, 3)", ""), "has no frames"},
             {npy("<f8", "(1, 3000000000, 2)", data), "says 3000000000 points"},
             {npy("<f8", "(1, 99999999999999999999, 2)", data), "has no length of 64 bits"},
             {npy("<f8", "(2, 2, 3", data), "has no length of 64 bits before '}"},
             {npy("<f8", "(1, 2, 3)", data), "has more numbers than its shape says"},
         }) {
        INFO(content);
        refuse(content, 1, fault);
    }
    refuse(npy("<f8", "(2, 3, 3)", data), 5, "the file ends before point 1 of frame 1");
    refuse(npy("<f8", "(1, 2000000000, 3)", data), 5, "the file ends before point 4 of frame 0");
    refuse(npy("<i8", "(1, 2)", numbers<std::int64_t>({1, (std::int64_t{1} << 53) + 1})), 1, "y is 9007199254740993");
    refuse(npy("<u8", "(1, 2)", numbers<std::uint64_t>({1, ~std::uint64_t{0}})), 1, "y is 18446744073709551615");
    // Frames before a fault are there.
    const Temporary_directory directory;
    Motion_reader reader(directory.file("a.npy", npy("<f8", "(3, 2, 3)", data)));
    Frame frame;
    CHECK(reader.next(frame));
    CHECK(reader.next(frame));
    CHECK_THROWS_AS(reader.next(frame), Input_error);
}
