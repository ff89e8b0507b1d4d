// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/cell_quality.h>

#include <support/catch.h>

#include <cmath>
#include <vector>

using namespace annulus;

TEST_CASE("regular cells have ratios of 1", "[measure][mesh]") {
    const Cell_quality q = cell_quality({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1});
    CHECK(q.volume == Approx(8.0 / 3));
    CHECK(q.radius_ratio == Approx(1).epsilon(1e-14));
    CHECK(q.aspect == Approx(1).epsilon(1e-14));
    CHECK(q.dihedral_min == Approx(70.528779365509308));
    CHECK(q.dihedral_max == Approx(70.528779365509308));
    CHECK(q.plane_min == Approx(60));
    const Triangle_quality t = triangle_quality({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    CHECK(t.radius_ratio == Approx(1).epsilon(1e-14));
    CHECK(t.aspect == Approx(1).epsilon(1e-14));
    CHECK(t.angle_min == Approx(60));
}

TEST_CASE("the corner of a cube and half a square, by hand", "[measure][mesh]") {
    // r = 1 / (3 + sqrt 3), R = sqrt(3) / 2; of the triangle r = 1 - 1 / sqrt 2, R = 1 / sqrt 2.
    for (const double scale : {1.0, 1e-20, 1e20}) {
        const Cell_quality q = cell_quality({0, 0, 0}, {scale, 0, 0}, {0, scale, 0}, {0, 0, scale});
        const double inner = 1 / (3 + std::sqrt(3.0));
        CHECK(q.radius_ratio == Approx(3 * inner / (std::sqrt(3.0) / 2)));
        CHECK(q.aspect == Approx(std::sqrt(2.0) / (2 * std::sqrt(6.0) * inner)));
        CHECK(q.dihedral_min == Approx(54.735610317245346));
        CHECK(q.dihedral_max == Approx(90));
        CHECK(q.plane_min == Approx(45));
        const Triangle_quality t = triangle_quality({0, 0, 0}, {scale, 0, 0}, {0, scale, 0});
        const double small = 1 - std::sqrt(0.5);
        CHECK(t.radius_ratio == Approx(2 * small / std::sqrt(0.5)));
        CHECK(t.aspect == Approx(std::sqrt(2.0) / (2 * std::sqrt(3.0) * small)));
        CHECK(t.angle_min == Approx(45));
    }
    // The other orientation.
    CHECK(cell_quality({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}).volume == Approx(1.0 / 6));
}

TEST_CASE("flat cells have the worst values", "[measure][mesh]") {
    const Cell_quality q = cell_quality({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    CHECK(q.radius_ratio == 0);
    CHECK(std::isinf(q.aspect));
    CHECK(q.dihedral_min == Approx(0).margin(1e-6));
    CHECK(q.plane_min == Approx(45));
    const Cell_quality line = cell_quality({0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0});
    CHECK(line.dihedral_min == 0);
    CHECK(line.dihedral_max == 180);
    CHECK(line.plane_min == 0);
    const Triangle_quality t = triangle_quality({0, 0, 0}, {1, 0, 0}, {2, 0, 0});
    CHECK(t.radius_ratio == 0);
    CHECK(std::isinf(t.aspect));
}

TEST_CASE("the worst cells come first, equal ones by number", "[measure][mesh]") {
    std::vector<Cell_quality> cells(5);
    for (std::size_t i = 0; i < 5; ++i) cells[i].dihedral_min = std::vector<double>{3, 1, 2, 1, 9}[i];
    CHECK(worst_cells(cells, 3) == std::vector<std::size_t>{1, 3, 2});
    CHECK(worst_cells(cells, 9) == std::vector<std::size_t>{1, 3, 2, 0, 4});
    CHECK(worst_cells({}, 9).empty());
}
