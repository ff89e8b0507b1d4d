// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/motion/mesh_quality.h>

#include <support/catch.h>

using namespace annulus;

TEST_CASE("angles and slivers of cells with a flag", "[measure][mesh]") {
    // Corner of a cube (three angles of 90 degrees, three of 54.7), a sliver (nearly a square), and one without a flag.
    const std::vector<Coordinates<3>> x{{0, 0, 0},    {1, 0, 0},  {0, 1, 0},    {0, 0, 1}, {5, 1, 0},
                                        {6, 0, 0.01}, {5, -1, 0}, {4, 0, 0.01}, {9, 9, 9}};
    const Mesh_cells<3> cells = linked({{0, 1, 2, 3}, {4, 6, 5, 7}, {0, 1, 3, 8}}, x.size());
    const std::vector<char> inside{1, 1, 0};
    const Mesh_quality q = mesh_quality(cells, inside, x);
    CHECK(q.cells == 2);
    CHECK(q.slivers == 1);
    CHECK(q.vertices == 8);
    CHECK(q.boundary == 8);
    CHECK(q.dihedral.total() == 12);
    CHECK(q.dihedral.counts()[10] == 3);                            // [50, 55)
    CHECK(q.dihedral.counts()[18] + q.dihedral.counts()[17] == 3);  // 90 up to rounding
    CHECK(q.dihedral.min() < 2);
    CHECK(q.dihedral.max() > 175);
    CHECK_THROWS_AS(mesh_quality(cells, std::vector<char>{1}, x), Error);
}

TEST_CASE("a flat cell is a sliver", "[measure][mesh]") {
    const std::vector<Coordinates<3>> x{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    const Mesh_quality q = mesh_quality(linked({{0, 1, 2, 3}}, 4), std::vector<char>{1}, x);
    CHECK(q.slivers == 1);
    CHECK(q.dihedral.total() < 6);  // not all angles are numbers
}

TEST_CASE("a cell is a sliver by one obtuse angle alone", "[measure][mesh]") {
    // Two long triangles on the edge of the first two corners, nearly in one plane: 170.3 degrees there, 160.7
    // opposite, 10.8 else.
    const std::vector<Coordinates<3>> x{{-0.5, 0, 0}, {0.5, 0, 0}, {0, -1, 0.085}, {0, 1, 0.085}};
    const Mesh_quality q = mesh_quality(linked({{0, 1, 2, 3}}, 4), std::vector<char>{1}, x);
    CHECK(q.dihedral.min() > Mesh_quality::sliver_degrees);
    CHECK(q.dihedral.max() > 180 - Mesh_quality::sliver_degrees);
    CHECK(q.slivers == 1);
}
