// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <limits>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::Temporary_directory;

namespace {

using Points_3 = std::vector<Coordinates<3>>;

/// Appends the bytes of a value in one byte order.
template <class T>
void put(std::string& out, T value, bool big_endian) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    if (big_endian == (std::endian::native == std::endian::little)) std::reverse(bytes, bytes + sizeof value);
    out.append(bytes, sizeof value);
}

template <int d = 3>
void refuse(std::string_view content, std::uint64_t line, const std::string& fault,
            Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file("a.ply", content), line, fault, [](const auto& file) { (void)read_points<d>(file); }, code);
}

Points_3 accept(std::string_view content) {
    const Temporary_directory directory;
    return read_points<3>(directory.file("a.ply", content)).points;
}

const std::string xyz = "property double x\nproperty double y\nproperty double z\n";

/// An element with a list before the vertices and one after, vertices with properties around the coordinates.
std::string binary_file(bool big_endian, double last_z = 6) {
    std::string out = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                      "_endian 1.0\ncomment x\nobj_info y\nelement before 2\nproperty list ushort double values\n"
                      "property short tag\nelement vertex 2\nproperty uchar red\nproperty float y\n"
                      "property list uchar int ring\nproperty double z\nproperty int x\nelement face 1\n"
                      "property list uchar uint vertex_indices\nend_header\n";
    for (std::uint16_t length : {std::uint16_t{0}, std::uint16_t{2}}) {
        put(out, length, big_endian);
        for (int i = 0; i < length; ++i) put(out, 0.5, big_endian);
        put(out, std::int16_t{-1}, big_endian);
    }
    const auto vertex = [&](std::int32_t x, float y, double z, std::uint8_t ring) {
        put(out, std::uint8_t{255}, big_endian);
        put(out, y, big_endian);
        put(out, ring, big_endian);
        for (int i = 0; i < ring; ++i) put(out, std::int32_t{10}, big_endian);  // 10 is a line end, too
        put(out, z, big_endian);
        put(out, x, big_endian);
    };
    vertex(-1, 2.5f, 3e-320, 3);
    vertex(4, 5, last_z, 0);
    put(out, std::uint8_t{1}, big_endian);
    put(out, std::uint32_t{7}, big_endian);
    return out;
}

}  // namespace

TEST_CASE("ply: ascii with other elements and lists around the coordinates") {
    CHECK(accept("ply\nformat ascii 1.0\nelement camera 1\nproperty list uchar float matrix\nelement vertex 2\n"
                 "property list uchar int ring\nproperty uchar red\nproperty float32 y\nproperty float64 x\n"
                 "property int16 z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                 "2 0.5 0.5\n3 1 2 3 255 2 1 3\n0 255 5 4.5 6\n3 0 1 0\n") == Points_3{{1, 2, 3}, {4.5, 5, 6}});
}

TEST_CASE("ply: binary of both byte orders, every part of every record") {
    for (const bool big_endian : {false, true}) {
        CHECK(accept(binary_file(big_endian)) == Points_3{{-1, 2.5, 3e-320}, {4, 5, 6}});
        const std::string whole = binary_file(big_endian);
        const std::size_t header = whole.find("end_header\n") + 11;
        // Wherever it is cut, the fault is reported at a record, and no cut file is read as a shorter one.
        for (std::size_t size = header; size < whole.size(); ++size) {
            const Temporary_directory directory;
            const auto file = directory.file("a.ply", whole.substr(0, size));
            CHECK_THROWS_AS(read_points<3>(file), Input_error);
        }
        refuse(whole + "x", 1, "1 byte follow");
        refuse(binary_file(big_endian, std::numeric_limits<double>::infinity()), 2, "z is infinite",
               Error_code::not_finite);
        refuse(binary_file(big_endian, std::numeric_limits<double>::quiet_NaN()), 2, "in binary vertex 2, z is nan",
               Error_code::not_finite);
    }
}

TEST_CASE("ply: every scalar type in both byte orders") {
    for (const bool big_endian : {false, true}) {
        const auto read = [&](const char* type, auto value) {
            std::string out = std::string("ply\nformat binary_") + (big_endian ? "big" : "little") +
                              "_endian 1.0\nelement vertex 1\n";
            for (const char* name : {"x", "y", "z"}) out += std::string("property ") + type + " " + name + "\n";
            out += "end_header\n";
            for (int i = 0; i < 3; ++i) put(out, value, big_endian);
            return accept(out).at(0)[2];
        };
        CHECK(read("char", std::int8_t{-100}) == -100);
        CHECK(read("uint8", std::uint8_t{200}) == 200);
        CHECK(read("short", std::int16_t{-30000}) == -30000);
        CHECK(read("uint16", std::uint16_t{60000}) == 60000);
        CHECK(read("int", std::int32_t{-2000000000}) == -2000000000.);
        CHECK(read("uint", std::uint32_t{4000000000u}) == 4000000000.);
        CHECK(read("float", 0.1f) == static_cast<double>(0.1f));
        CHECK(read("float64", 0.1) == 0.1);
    }
}

TEST_CASE("ply: faults of the header name its line") {
    refuse("plyx\n", 1, "does not begin with ply");
    refuse("\nply\n", 2, "does not begin with ply");
    refuse("ply\nelement vertex 1\n" + xyz + "end_header\n1 2 3\n", 6, "no format line");
    refuse("ply\nformat ascii 2.0\n", 2, "bad format line");
    refuse("ply\nformat text 1.0\n", 2, "unknown format 'text'");
    refuse("ply\nformat ascii 1.0\nelement vertex\n", 3, "bad element line");
    refuse("ply\nformat ascii 1.0\nelement vertex -1\n", 3, "not an integer");
    refuse("ply\nformat ascii 1.0\nproperty float x\n", 3, "before any element");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\n", 4, "unknown type 'half'");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int x\n", 4, "no integer type");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty x\n", 4, "bad property line");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nhello\n", 4, "unknown header line 'hello'");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\n" + xyz, 6, "ends within its header");
    refuse("ply\nformat ascii 1.0\nend_header\n", 3, "0 elements vertex");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty float y\nend_header\n1\n", 5, "no property x");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int x\nend_header\n", 5,
           "no plain property x");
    refuse(
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float x\nproperty float y\nend_header\n1 "
        "2 3\n",
        7, "no plain property x");
    refuse("ply\nformat ascii 1.0\nelement vertex 1\n" + xyz + "element vertex 1\nend_header\n1 2 3\n", 8,
           "2 elements vertex");
}

TEST_CASE("ply: faults of ascii records name their line") {
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 2\n" + xyz + "end_header\n";
    CHECK(accept(head + "1 2 3\n4 5 6\n") == Points_3{{1, 2, 3}, {4, 5, 6}});
    refuse(head + "1 2 3\n", 8, "ends after 1 of 2");
    refuse(head + "1 2 3\n4 5\n", 9, "z is missing");
    refuse(head + "1 2 3\n4 5 6 7\n", 9, "has 4 columns");
    refuse(head + "1 2 3\n4 b 6\n", 9, "y is not a number: 'b'");
    refuse(head + "1 2 3\n4 inf 6\n", 9, "y is infinite", Error_code::not_finite);
    refuse(head + "1 2 3\n4 5 6\n7 8 9\n", 10, "there is more");
    refuse<2>(head + "1 2 3\n4 5 6\n", 8, "has a z coordinate");
}

TEST_CASE("ply: a binary count or list length beyond the file is refused before memory is allocated") {
    const std::string head = "ply\nformat binary_little_endian 1.0\n";
    refuse(head + "element vertex 18446744073709551615\n" + xyz + "end_header\nabc", 1, "only 3 bytes are left");
    std::string list = head + "element vertex 1\nproperty list int double a\n" + xyz + "end_header\n";
    put(list, std::int32_t{2147483647}, false);
    refuse(list + std::string(100, '\0'), 1, "the file ends");
    std::string negative = head + "element vertex 1\nproperty list char double a\n" + xyz + "end_header\n";
    put(negative, std::int8_t{-1}, false);
    refuse(negative + std::string(100, '\0'), 1, "is negative");
    refuse(head + "element nothing 18446744073709551615\nelement vertex 1\n" + xyz + "end_header\n", 1, "0 bytes");
}
