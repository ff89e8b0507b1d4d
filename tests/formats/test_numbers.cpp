// SPDX-License-Identifier: GPL-3.0-or-later
#include "temporary_directory.h"

#include <apps/formats/decimal.h>
#include <apps/formats/read_mesh.h>
#include <apps/formats/read_points.h>
#include <apps/formats/text_input.h>
#include <apps/formats/write_mesh.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace annulus;
using annulus::testing::for_all;
using annulus_test::Temporary_directory;

namespace {

/// Any finite double, every exponent alike: subnormals, zeros of both signs, the largest.
rc::Gen<double> finite_double() {
    return rc::gen::map(rc::gen::resize(1000, rc::gen::arbitrary<std::uint64_t>()), [](std::uint64_t bits) {
        const double x = std::bit_cast<double>(bits);
        return std::isfinite(x) ? x : std::bit_cast<double>(bits & 0x800fffffffffffffu);
    });
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

double parsed(std::string_view text) {
    double value = -1;
    REQUIRE(parse_double(text, value) == Number_kind::finite);
    return value;
}

}  // namespace

TEST_CASE("decimals are rounded to nearest, at both ends of the range too") {
    CHECK(parsed("0.1") == 0.1);
    CHECK(parsed("+.5") == 0.5);
    CHECK(parsed("1.") == 1);
    CHECK(parsed("9007199254740993") == 9007199254740992.);  // a tie, to even
    CHECK(parsed("9007199254740993.00000000000000000000000000000000000000001") == 9007199254740994.);
    CHECK(parsed("4.9e-324") == std::numeric_limits<double>::denorm_min());
    CHECK(parsed("1e-400") == 0);
    CHECK(bits(parsed("-1e-400")) == bits(-0.));
    CHECK(bits(parsed("-0")) == bits(-0.));
    CHECK(parsed("0." + std::string(400, '0') + "1e401") == 1);
    CHECK(parsed("1" + std::string(400, '0') + "e-400") == 1);
    CHECK(parsed("0." + std::string(400, '0') + "1") == 0);
    CHECK(parsed("1.7976931348623157e308") == std::numeric_limits<double>::max());
    double unused = 0;
    CHECK(parse_double("1" + std::string(400, '0'), unused) == Number_kind::too_large);
    CHECK(parse_double("0.0001e400", unused) == Number_kind::too_large);
    CHECK(parse_double("1.7976931348623159e308", unused) == Number_kind::too_large);
    CHECK(parse_double("-infinity", unused) == Number_kind::too_large);
    CHECK(parse_double("NaN", unused) == Number_kind::nan);
    for (const char* text :
         {"",      "+",     "-",   ".",    "e5", "1e",     "1 ",     " 1",       "1e5x",     "0x1p3",   "++1",    "+-1",
          "1_000", "1e+-5", "1,5", "1.5D", "D1", "1.5+10", "15+101", "2024-101", "1.5+1011", "1.5+1x1", "1.5d+-1"})
        CHECK(parse_double(text, unused) == Number_kind::not_a_number);
}

TEST_CASE("exponents as Fortran writes them are exponents") {
    CHECK(parsed("1.5D+01") == 15);
    CHECK(parsed("-1.5d1") == -15);
    CHECK(parsed("+2D-2") == 0.02);
    CHECK(parsed("0.1D0") == 0.1);
    CHECK(parsed("1.5+101") == 1.5e101);
    CHECK(parsed("-.5-101") == -0.5e-101);
    CHECK(parsed("1.-300") == 1e-300);
    double unused = 0;
    CHECK(parse_double("1D400", unused) == Number_kind::too_large);
    CHECK(parsed("1.0-999") == 0);
    // No longer than any program writes a number.
    CHECK(parsed("1." + std::string(60, '0') + "D1") == 10);
    CHECK(parse_double("1." + std::string(61, '0') + "D1", unused) == Number_kind::not_a_number);
}

TEST_CASE("writing and reading a double gives its bits back") {
    CHECK(for_all("decimal, then parse_double", [] {
        const double x = *finite_double();
        double y = 0;
        RC_ASSERT(parse_double(decimal(x), y) == Number_kind::finite);
        RC_ASSERT(bits(x) == bits(y));
    }));
}

TEST_CASE("a mesh is read back bit for bit") {
    const Temporary_directory directory;
    CHECK(for_all("write_mesh, then read_mesh and read_points, in two dimensions", [&] {
        const auto size = *rc::gen::inRange<std::size_t>(3, 20);
        const auto points = *rc::gen::container<std::vector<Coordinates<2>>>(
            size, rc::gen::map(rc::gen::pair(finite_double(), finite_double()), [](const auto& p) {
                return Coordinates<2>{p.first, p.second};
            }));
        std::vector<std::array<Index, 3>> cells;
        for (Index i = 2; i < static_cast<Index>(size); ++i) cells.push_back({i, i - 2, i - 1});
        const auto file = directory.file("a.mesh", write_mesh<2>(points, cells));
        const auto mesh = std::get<Mesh_file<2>>(read_mesh(file));
        RC_ASSERT(mesh.cells == cells);
        RC_ASSERT(mesh.points.size() == size);
        const auto again = read_points<2>(file);
        for (std::size_t i = 0; i < size; ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                RC_ASSERT(bits(mesh.points[i][k]) == bits(points[i][k]));
                RC_ASSERT(bits(again.points[i][k]) == bits(points[i][k]));
            }
    }));
}

TEST_CASE("any bytes at all are read or refused, never more") {
    const Temporary_directory directory;
    const auto name = GENERATE(as<std::string>(), "a.xyz", "a.csv", "a.off", "a.ply", "a.mesh");
    const std::vector<std::string> pieces = {"OFF",
                                             "ply",
                                             "MeshVersionFormatted",
                                             "Dimension",
                                             "Vertices",
                                             "Triangles",
                                             "End",
                                             "format",
                                             "ascii",
                                             "1.0",
                                             "2",
                                             "3",
                                             "1e400",
                                             "-1",
                                             "nan",
                                             "\n",
                                             "\n",
                                             " ",
                                             ",",
                                             "x",
                                             "y",
                                             "element",
                                             "vertex",
                                             "property",
                                             "float",
                                             "end_header",
                                             "list",
                                             "uchar",
                                             "binary_little_endian",
                                             "99999999999",
                                             std::string("\0\xff", 2),
                                             "#",
                                             "\"",
                                             "\r\n"};
    CHECK(for_all("read_points on " + name, [&] {
        std::string content = *rc::gen::element<std::string>(
            "", "OFF\n", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n",
            "ply\nformat binary_big_endian 1.0\nelement vertex 2\nproperty list uchar int a\nproperty char x\n"
            "property char y\nend_header\n",
            "MeshVersionFormatted 2\nDimension 2\nVertices\n");
        for (const auto& piece : *rc::gen::container<std::vector<std::string>>(rc::gen::elementOf(pieces)))
            content += piece + (*rc::gen::arbitrary<bool>() ? " " : "");
        try {
            const auto file = read_points<2>(directory.file(name, content));
            RC_ASSERT(!file.points.empty());
            RC_ASSERT(file.lines.size() == file.points.size());
        } catch (const Input_error& error) {
            RC_ASSERT(std::string(error.what()).find('\n') == std::string::npos);
        }
    }));
}
