// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/read_mesh.h>
#include <apps/formats/write_mesh.h>

#include <support/catch.h>

#include <limits>

using namespace annulus;
using annulus_test::expect_fault;
using annulus_test::Temporary_directory;

namespace {

void refuse(std::string_view content, std::uint64_t line, const std::string& fault) {
    const Temporary_directory directory;
    expect_fault(directory.file("a.mesh", content), line, fault, [](const auto& file) { (void)read_mesh(file); });
}

}  // namespace

TEST_CASE("triangles and tetrahedra are read in their order and orientation") {
    const Temporary_directory directory;
    const auto flat = std::get<Mesh_file<2>>(
        read_mesh(directory.file("a.mesh",
                                 "MeshVersionFormatted 2\nDimension\n2\nTriangles\n2\n1 2 3 0\n1 4 3 7\n\nVertices\n4\n"
                                 "0 0 0\n1 0 0\n1 1 0\n0 1 0\nEnd\n")));
    CHECK(flat.points.size() == 4);
    CHECK(flat.cells == std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 3, 2}});
    CHECK(flat.cell_lines == std::vector<std::uint64_t>{6, 7});
    CHECK(flat.point_lines == std::vector<std::uint64_t>{11, 12, 13, 14});
    const auto solid = std::get<Mesh_file<3>>(read_mesh(
        directory.file("b.mesh",
                       "MeshVersionFormatted 1\nDimension 3\nVertices\n4\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n"
                       "Triangles\n1\n1 2 3 0\nTetrahedra\n1\n4 3 2 1 5\n")));
    CHECK(solid.cells == std::vector<std::array<Index, 4>>{{3, 2, 1, 0}});
    CHECK(solid.points[3] == Coordinates<3>{0, 0, 1});
}

TEST_CASE("edges are the cells of points on a line, written and read") {
    const Temporary_directory directory;
    const std::vector<Coordinates<2>> points{{0, 0}, {2, 2}, {1, 1}};
    const std::vector<std::array<Index, 3>> edges{{0, 2, none}, {1, 2, none}};
    const std::string text = write_mesh<2>(points, edges);
    CHECK(text ==
          "MeshVersionFormatted 2\nDimension 2\n\nVertices\n3\n0 0 0\n2 2 0\n1 1 0\n\n"
          "Edges\n2\n1 3 0\n2 3 0\n\nTriangles\n0\n\nEnd\n");
    const auto mesh = std::get<Mesh_file<2>>(read_mesh(directory.file("a.mesh", text)));
    CHECK(mesh.cells == edges);
    CHECK(mesh.cell_lines == std::vector<std::uint64_t>{12, 13});
    // With triangles they are the border edges that other programs write.
    const auto solid = std::get<Mesh_file<2>>(
        read_mesh(directory.file("b.mesh",
                                 "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n0 1 0\n"
                                 "Edges\n1\n1 2 9\nTriangles\n1\n1 2 3 0\n")));
    CHECK(solid.cells == std::vector<std::array<Index, 3>>{{0, 1, 2}});
    const std::vector<std::array<Index, 3>> half{{0, none, none}};
    CHECK_THROWS_AS(write_mesh<2>(points, half), Error);
}

TEST_CASE("faults of cells name their line") {
    const std::string head = "MeshVersionFormatted 2\nDimension 2\nVertices\n3\n0 0 0\n1 0 0\n1 1 0\n";
    refuse(head + "Triangles\n1\n1 2 3 0.0\nEnd\n", 10, "the reference");
    refuse(head + "End\n", 8, "has no triangles");
    refuse(head + "Triangles\n0\nEnd\n", 10, "has no triangles");
    refuse(head + "Triangles\n1\n1 2 4 0\nEnd\n", 10, "names vertex 4 of 3");
    refuse(head + "Edges\n1\n1 4 0\nTriangles\n1\n1 2 3 0\nEnd\n", 10, "names vertex 4 of 3");
    refuse(head + "Triangles\n1\n0 1 2 0\nEnd\n", 10, "names vertex 0");
    refuse(head + "Triangles\n1\n1 2 -1 0\nEnd\n", 10, "not an integer of 0 or more");
    refuse(head + "Triangles\n1\n1 2 4294967297 0\nEnd\n", 10, "names vertex 4294967297");
    refuse(head + "Triangles\n1\n1 2 2 0\nEnd\n", 10, "names vertex 2 twice");
    refuse(head + "Triangles\n1\n1 2 3\nEnd\n", 10, "has 3 columns");
    refuse(head + "Triangles\n2\n1 2 3 0\n", 10, "ends after 1 of 2 Triangles");
    refuse(head + "Triangles\n1\n1 2 3 0\nTriangles\n1\n1 2 3 0\n", 11, "a second section Triangles");
    refuse(head + "Triangles\n2000000000\n1 2 3 0\n", 10, "ends after 1 of 2000000000 Triangles");
    refuse("MeshVersionFormatted 2\nDimension 2\nTriangles\n1\n1 2 3 0\nEnd\n", 5, "names vertex 1 of 0");
    refuse("\n\n", 1, "");
}

TEST_CASE("write_mesh writes the format to the letter and refuses what no reader would take") {
    const std::vector<Coordinates<2>> points = {{0, 0.1}, {1e-7, -3}, {1, 1}};
    const std::vector<std::array<Index, 3>> cells = {{0, 1, 2}};
    CHECK(write_mesh<2>(points, cells) ==
          "MeshVersionFormatted 2\nDimension 2\n\nVertices\n3\n0 0.1 0\n1e-07 -3 0\n1 1 0\n\n"
          "Triangles\n1\n1 2 3 0\n\nEnd\n");
    const std::vector<Coordinates<2>> bad = {{0, std::numeric_limits<double>::infinity()}};
    CHECK_THROWS_AS(write_mesh<2>(bad, {}), Error);
    const std::vector<std::array<Index, 3>> too_far = {{0, 1, 3}};
    CHECK_THROWS_AS(write_mesh<2>(points, too_far), Error);
    const std::vector<std::array<Index, 3>> negative = {{0, infinite, 2}};
    CHECK_THROWS_AS(write_mesh<2>(points, negative), Error);
}

TEST_CASE("a part of a mesh is written with its boundary and no other points") {
    const std::vector<Coordinates<3>> points{{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {8, 8, 8}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<std::array<Index, 4>> cells{{1, 2, 4, 5}};
    const std::vector<std::array<Index, 3>> facets{{2, 4, 5}, {1, 5, 4}, {1, 2, 5}, {1, 4, 2}};
    CHECK(write_mesh(mesh_part(points, cells, facets)) ==
          "MeshVersionFormatted 2\nDimension 3\n\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n\n"
          "Triangles\n4\n2 3 4 0\n1 4 3 0\n1 2 4 0\n1 3 2 0\n\nTetrahedra\n1\n1 2 3 4 0\n\nEnd\n");
    CHECK(write_mesh(mesh_part(points, {}, {})) ==
          "MeshVersionFormatted 2\nDimension 3\n\nVertices\n0\n\nTriangles\n0\n\nTetrahedra\n0\n\nEnd\n");
    const std::vector<std::array<Index, 4>> wrong{{1, 2, 4, 6}};
    CHECK_THROWS_AS(mesh_part(points, wrong, facets), Error);
    const std::vector<std::array<Index, 3>> stray{{0, 1, 2}};
    CHECK_THROWS_AS(mesh_part(points, cells, stray), Error);
}
