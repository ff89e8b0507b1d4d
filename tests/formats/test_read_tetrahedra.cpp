// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/read_tetrahedra.h>
#include <apps/motion/surface_3.h>

#include <support/catch.h>

#include <map>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::Temporary_directory;

namespace {

/// Lines 1 to 8 are the head and four vertices: an orthogonal tetrahedron.
const std::string head = "MeshVersionFormatted 2\nDimension 3\nVertices\n";
std::string text(const std::string& points, int n, const std::string& cells, int m) {
    return head + std::to_string(n) + "\n" + points + "Tetrahedra\n" + std::to_string(m) + "\n" + cells + "End\n";
}
const std::string four = "0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n";
const std::string five = four + "1 1 1 0\n";

void refuse(const std::string& content, std::uint64_t line, const std::string& fault) {
    const Temporary_directory directory;
    expect_fault(directory.file("a.mesh", content), line, fault, [](const auto& file) { (void)read_tetrahedra(file); });
}

Tetrahedra_file read(const std::string& content) {
    const Temporary_directory directory;
    return read_tetrahedra(directory.file("a.mesh", content));
}

}  // namespace

TEST_CASE("a tetrahedral mesh has its boundary, counter-clockwise from outside") {
    const auto mesh = read(text(five, 5, "1 2 3 4 7\n2 3 4 5 8\n", 2));
    CHECK(mesh.points.size() == 5);
    CHECK(mesh.cell_lines == std::vector<std::uint64_t>{12, 13});
    CHECK(mesh.boundary.triangles.size() == 6);
    CHECK(mesh.boundary.cells == std::vector<std::size_t>{0, 0, 0, 1, 1, 1});
    CHECK(mesh.merged + mesh.unused == 0);
    CHECK_FALSE(mesh.turned);
    std::map<std::pair<Index, Index>, int> sides;
    const Triangle_surface surface = mesh.surface();
    for (const auto& t : surface.triangles)
        for (std::size_t i = 0; i < 3; ++i) ++sides[{t[i], t[(i + 1) % 3]}];
    for (const auto& [side, n] : sides) {
        CHECK(n == 1);
        CHECK(sides.contains({side.second, side.first}));
    }
    CHECK(enclosed_volume(surface) == Approx(0.5));
}

TEST_CASE("points of a tetrahedral mesh are used, and at different places") {
    const auto mesh = read(text("9 9 9 0\n" + four + "0 0 0 3\n8 8 8 0\n1 0 0 0\n-0 1 0 0\n", 9, "2 8 9 5 0\n", 1));
    CHECK(mesh.points == std::vector<Coordinates<3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    CHECK(mesh.cells == std::vector<std::array<Index, 4>>{{0, 1, 2, 3}});
    CHECK(mesh.unused == 5);
    const auto halves = read(text(four + "1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 0\n", 8, "1 2 3 4 0\n5 6 7 8 0\n", 2));
    CHECK(halves.merged == 3);
    CHECK(halves.boundary.triangles.size() == 6);
    // A mesh in which only the interior vertex is in no triangle.
    const auto star = read(text(four + "0.2 0.2 0.2 0\n", 5, "1 2 3 5 0\n1 3 4 5 0\n1 4 2 5 0\n2 4 3 5 0\n", 4));
    CHECK(star.points.size() == 5);
    CHECK(star.surface().points.size() == 4);
}

TEST_CASE("a mesh of which all tetrahedra are negative is turned") {
    const auto mesh = read(text(five, 5, "1 2 4 3 0\n2 3 5 4 0\n", 2));
    CHECK(mesh.turned);
    CHECK(enclosed_volume(mesh.surface()) == Approx(0.5));
}

TEST_CASE("what other programs write is read") {
    for (const std::string& begin : {std::string("MeshVersionFormatted 1\nDimension\n3\n"),
                                     std::string("MeshVersionFormatted\n2\n\nDimension 3\n"),
                                     std::string(" MeshVersionFormatted 2\r\n Dimension\r\n 3\r\n"),
                                     std::string("# made by hand\nMeshVersionFormatted 1 # single\nDimension 3\n")})
        CHECK(read(begin + "Vertices\n4\n" + four +
                   "Triangles\n1\n1 2 3 -4\nRidges\n1\n1\nTetrahedra\n# one\n1\n1 2 3 4 12 # a reference\n")
                  .cells.size() == 1);
}

TEST_CASE("every fault of a tetrahedral mesh has its line") {
    refuse("MeshVersionFormatted 2\nDimension 2\nVertices\n0\n", 4, "is a 2D mesh");
    refuse("MeshVersionFormatted 2\nDimension 3\n", 2, "has no points");
    refuse(head + "4\n" + four, 8, "has no tetrahedra");
    refuse(head + "4\n" + four + "Triangles\n1\n1 2 3 0\n", 11, "has no tetrahedra");
    refuse(text(four, 4, "1 2 3 5 0\n", 1), 11, "names vertex 5 of 4");
    refuse(text(four, 4, "1 2 3 3 0\n", 1), 11, "names vertex 3 twice");
    refuse(text(four, 4, "1 2 3 4\n", 1), 11, "has 4 columns");
    refuse(text(four + "0 0 0 0\n", 5, "1 2 3 5 0\n", 1), 12, "two corners at one point");
    refuse(text(four + "0.5 0.5 0 0\n", 5, "1 2 3 4 0\n1 2 3 5 0\n", 2), 13, "no volume");
    refuse(text(five, 5, "1 2 3 4 0\n2 3 5 4 0\n", 2), 13, "inverted against that at line 12");
    refuse(text(five + "2 2 2 0\n", 6, "1 2 3 4 0\n2 3 4 5 0\n2 3 4 6 0\n", 3), 15,
           "more than two tetrahedra, one of them at line 13");
    refuse(text(four + "0 0 2 0\n", 5, "1 2 3 4 0\n1 2 3 5 0\n", 2), 13,
           "same side of their common facet as that at line 12");
    // Two that share an edge only; that share the middle of a facet; one in the other; that a corner of one touches.
    refuse(text(four + "-1 0 0 0\n0 -1 0 0\n", 6, "1 2 3 4 0\n1 5 6 4 0\n", 2), 14, "an edge is in 4 facets");
    refuse(text(four + "0.1 0.1 0 0\n0.5 0.1 0 0\n0.1 0.5 0 0\n0.1 0.1 -1 0\n", 8, "1 2 3 4 0\n5 7 6 8 0\n", 2), 15,
           "meets one of the tetrahedron at line 16");
    refuse(text(four + "0.2 0.2 -1 0\n0.1 0.2 -1 0\n0.2 0.1 -1 0\n0.1 0.1 0 0\n", 8, "1 2 3 4 0\n5 6 7 8 0\n", 2), 15,
           "meets one of the tetrahedron at line 16");
}

TEST_CASE("sheets may touch at a vertex of a tetrahedral mesh") {
    const auto mesh = read(text(four + "-1 0 0 0\n0 -1 0 0\n0 0 -1 0\n", 7, "1 2 3 4 0\n1 6 5 7 0\n", 2));
    CHECK(mesh.surface().points.size() == 7);
    CHECK(Surface_3(mesh.surface()).volume() == Approx(1.0 / 3));
}

TEST_CASE("a part of a mesh within another covers space twice; a cavity does not") {
    const std::string inner = "0.1 0.1 0.1 0\n0.2 0.1 0.1 0\n0.1 0.2 0.1 0\n0.1 0.1 0.2 0\n";
    const auto nested = read(text(four + inner, 8, "1 2 3 4 0\n5 6 7 8 0\n", 2));
    const Surface_3 twice(nested.surface());
    const auto cell = covered_twice(twice, nested.points, nested.cells, nested.boundary);
    REQUIRE(cell);
    CHECK(*cell == 1);
    const auto apart = read(text(four + "10 0 0 0\n11 0 0 0\n10 1 0 0\n10 0 1 0\n", 8, "1 2 3 4 0\n5 6 7 8 0\n", 2));
    CHECK_FALSE(covered_twice(Surface_3(apart.surface()), apart.points, apart.cells, apart.boundary));
}
