// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "gzip.h"
#include "temporary_directory.h"

#include <apps/formats/read_surface.h>

#include <support/catch.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::gzip;
using annulus_test::Temporary_directory;

namespace {

Surface_file accept(const std::string& name, std::string_view content) {
    const Temporary_directory directory;
    return read_surface(directory.file(name, content));
}

void refuse(const std::string& name, std::string_view content, std::uint64_t line, const std::string& fault,
            Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file(name, content), line, fault, [](const auto& file) { (void)read_surface(file); }, code);
}

const std::vector<Coordinates<3>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.5}};
const std::vector<std::array<Index, 3>> sides{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// The tetrahedron, its points in any order.
void check_tetrahedron(const Surface_file& file, std::uint64_t merged = 0) {
    CHECK(file.surface.points.size() == 4);
    CHECK(file.surface.triangles.size() == 4);
    CHECK(file.merged == merged);
    CHECK(enclosed_volume(file.surface) == Approx(1.0 / 12).epsilon(1e-15));
    for (const auto& p : file.surface.points) CHECK(std::find(corners.begin(), corners.end(), p) != corners.end());
}

std::string stl(bool binary) {
    std::string out = binary ? std::string("solid is what a binary file may begin with, too") : "solid tetrahedron\n";
    if (binary) {
        out.resize(80, ' ');
        out += std::string("\4\0\0\0", 4);
    }
    for (const auto& t : sides) {
        if (binary) out.append(12, '\0');
        else out += " facet normal 0 0 0\n  outer loop\n";
        for (const Index i : t) {
            const auto& p = corners[static_cast<std::size_t>(i)];
            if (!binary)
                out += "   vertex " + std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) +
                       "\n";
            for (std::size_t k = 0; binary && k < 3; ++k) {
                const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(p[k]));
                for (unsigned b = 0; b < 4; ++b) out += static_cast<char>(bits >> (8 * b) & 255);
            }
        }
        out += binary ? std::string(2, '\0') : "  endloop\n endfacet\n";
    }
    return binary ? out : out + "endsolid tetrahedron\n";
}

const std::string off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n";
const std::string obj = "# a comment\nv 0 0 0\nv 1 0 0\nvn 0 0 1\nv 0 1 0\nv 0 0 0.5\ng group\n";
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 4\nproperty uchar colour\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n";

}  // namespace

TEST_CASE("a tetrahedron in every format of surfaces", "[io][surface]") {
    check_tetrahedron(accept("a.off", off + "3 0 2 1\n3 0 1 3 255 0 0\n3 0 3 2\n3 1 2 3\n"));
    check_tetrahedron(accept("a.OBJ", obj + "f 1 3/7/8 2//1\nf 1/1 2 4\nf -4 -1 -2\nusemtl x\nf 2 3 4\n"));
    check_tetrahedron(accept("a.ply", ply + "7 3 0 2 1\n7 3 0 1 3\n7 3 0 3 2\n7 3 1 2 3\n"));
    check_tetrahedron(accept("a.stl", stl(false)), 8);
    check_tetrahedron(accept("a.stl", stl(true)), 8);
    std::string capitals = stl(false);
    for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    check_tetrahedron(accept("A.STL", capitals), 8);
    check_tetrahedron(accept("a.stl.gz", gzip(stl(true))), 8);
    std::string binary =
        "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
        "property double z\nelement face 4\nproperty list uchar uint vertex_index\nend_header\n";
    for (const auto& p : corners)
        for (const double x : p) {
            char bytes[8];
            std::memcpy(bytes, &x, 8);
            binary.append(bytes, 8);
        }
    for (const auto& t : sides) {
        binary += '\3';
        for (const Index i : t) binary += std::string{static_cast<char>(i), 0, 0, 0};
    }
    check_tetrahedron(accept("a.ply", binary));
    refuse("a.ply", binary.substr(0, binary.size() - 1), 4, "the file ends");
}

TEST_CASE("a surface that is inside out is turned, polygons are cut, unused points dropped", "[io][surface]") {
    check_tetrahedron(accept("a.off", off + "3 0 1 2\n3 0 3 1\n3 0 2 3\n3 1 3 2\n"));
    const Surface_file cube = accept("cube.obj",
                                     "v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
                                     "f 2 5 4 3\nf 6 7 8 9\nf 2 3 7 6\nf 3 4 8 7\nf 4 5 9 8\nf 5 2 6 9\n");
    CHECK(cube.surface.points.size() == 8);
    CHECK(cube.surface.triangles.size() == 12);
    CHECK(enclosed_volume(cube.surface) == Approx(1).epsilon(1e-15));
}

TEST_CASE("surfaces that are not closed are refused where it shows", "[io][surface]") {
    refuse("a.off", off + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 3 2\n", 10, "turned against");
    refuse("a.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n", 7, "in one triangle only");
    refuse("a.off",
           "OFF\n5 6 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 2\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n3 0 1 4\n3 1 0 4\n", 12,
           "in 4 triangles");
    refuse("a.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 2 1\n3 0 1 2\n3 1 2 3\n3 1 3 2\n", 9,
           "in 4 triangles");
    refuse("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 2 1\n3 0 1 2\n", 1, "encloses no volume");
}

TEST_CASE("faces that are wrong are refused with their line", "[io][surface]") {
    refuse("a.off", off + "3 0 2 1\n3 0 1 4\n3 0 3 2\n3 1 2 3\n", 8, "names vertex 4 (from 0) of 4");
    refuse("a.off", off + "3 0 2 1\n3 0 1 -3\n3 0 3 2\n3 1 2 3\n", 8, "not an integer of 0 or more");
    refuse("a.off", off + "3 0 2 1\n3 0 1 1\n3 0 3 2\n3 1 2 3\n", 8, "two corners at one point");
    refuse("a.off", off + "3 0 2 1\n2 0 1\n3 0 3 2\n3 1 2 3\n", 8, "a face of 2 corners");
    refuse("a.off", "OFF\n1 0 0\n0 0 0\n", 1, "no faces");
    refuse("a.off", "OFF\n4 4 6\n0 0 0\n1 0 nan\n0 1 0\n0 0 0.5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", 4, "z is nan",
           Error_code::not_finite);
    refuse("a.obj", obj + "f 1 3 0\n", 8, "is 0");
    refuse("a.obj", obj + "f 1 3 -5\n", 8, "no vertex '-5'");
    refuse("a.obj", obj + "f 1 3 x\n", 8, "not an integer");
    refuse("a.obj", "v 1 2\n", 1, "2 coordinates");
    refuse("a.ply", ply + "7 3 0 2 1\n7 3 0 1 9\n7 3 0 3 2\n7 3 1 2 3\n", 16, "names vertex 9");
    refuse("a.ply", ply + "7 3 0 2 1\n7 3 0 1\n7 3 0 3 2\n7 3 1 2 3\n", 16, "is missing");
    refuse("a.stl", "solid x\nfacet normal 0 0 0\nvertex 0 0 0\nvertex 0 1 0\nendfacet\n", 5, "2 vertices");
    refuse("a.stl", "solid x\nfacet normal 0 0 0\nvertex 0 0 0\n", 3, "ends within a facet");
    refuse("a.stl", "solid x\nvertex 0 0 0\n", 2, "outside of any facet");
    refuse("a.stl", "solid x\nfacett\n", 2, "unknown word 'facett'");
    refuse("a.stl", stl(true).substr(0, 200), 0, "200 bytes for 4 binary triangles");
    refuse("a.stl", stl(true).substr(0, 200).replace(0, 5, "other"), 0, "200 bytes for 4 binary triangles");
    refuse("a.stl", "x", 1, "neither ASCII nor binary");
    refuse("a.xyz", "0 0 0\n", 0, "unknown extension");
}

TEST_CASE("strips of triangles of a PLY become triangles", "[io][surface]") {
    const std::string points =
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n";
    const std::string ascii = "ply\nformat ascii 1.0\n" + points + "0 0 0\n1 0 0\n0 1 0\n0 0 0.5\n";
    // One strip; two that -1 parts; two that repeated corners join.
    check_tetrahedron(accept("a.ply", ascii + "6 0 2 1 3 0 2\n"));
    check_tetrahedron(accept("a.ply", ascii + "9 0 2 1 3 -1 1 3 0 2\n"));
    check_tetrahedron(accept("a.ply", ascii + "12 -1 0 2 1 3 3 1 1 3 0 2 -1\n"));
    const Surface_file strip = accept("a.ply", ascii + "6 0 2 1 3 0 2\n");
    // Points are numbered as the strip names them: 0, 2, 1, 3 are 0, 1, 2, 3.
    CHECK(strip.surface.triangles == std::vector<std::array<Index, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 0}, {0, 3, 1}});
    for (const bool big : {false, true}) {
        std::string binary = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + points;
        const auto put = [&](auto value) {
            char bytes[4];
            std::memcpy(bytes, &value, 4);
            if (big == (std::endian::native == std::endian::little)) std::reverse(bytes, bytes + 4);
            binary.append(bytes, 4);
        };
        for (const auto& p : corners)
            for (const double x : p) put(static_cast<float>(x));
        for (const std::int32_t i : {9, 0, 2, 1, 3, -1, 1, 3, 0, 2}) put(i);
        check_tetrahedron(accept("a.ply", binary));
    }
    refuse("a.ply", ascii + "3 0 2 -2\n", 14, "the index of a vertex");
    refuse("a.ply", ascii + "3 0 2 9\n", 14, "9");
    refuse("a.ply", ascii + "9 0 2 1 3 18446744073709551615 1 3 0 2\n", 14, "");
    refuse("a.ply", ascii + "2 0 2\n", 1, "has no faces");
    refuse("a.ply", ascii + "4 0 2 1 3\n", 14, "");
}
