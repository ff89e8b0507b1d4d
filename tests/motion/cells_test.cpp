// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/error.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/cells_3.h>
#include <apps/motion/dihedral.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace annulus;
using namespace annulus_test;

namespace {

Moving_delaunay_3 delaunay(const std::vector<Coordinates<3>>& points) {
    Options options;
    options.strategy = Strategy::rebuild;
    return Moving_delaunay_3(points, options);
}

}  // namespace

TEST_CASE("adjacency is what shares three vertices", "[motion][cells]") {
    const auto points = random_points(60, 3);
    const Mesh_cells<3> cells = linked(delaunay(points).audit_input().cells, points.size());
    std::size_t open = 0;
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i) {
            std::set<Index> facet(cells.vertices[c].begin(), cells.vertices[c].end());
            facet.erase(cells.vertices[c][i]);
            std::vector<Index> others;
            for (std::size_t e = 0; e < cells.vertices.size(); ++e) {
                const std::set<Index> all(cells.vertices[e].begin(), cells.vertices[e].end());
                if (e != c && std::includes(all.begin(), all.end(), facet.begin(), facet.end()))
                    others.push_back(static_cast<Index>(e));
            }
            REQUIRE(others.size() <= 1);
            open += others.empty();
            CHECK(cells.neighbours[c][i] == (others.empty() ? cells.outside : others[0]));
        }
    // Facets of the hull: those of all cells are a closed surface, counter-clockwise from outside.
    const auto hull = surface_facets(cells, std::vector<char>(cells.vertices.size(), 1));
    CHECK(hull.size() == open);
    const Triangle_surface surface{points, hull};
    CHECK(closed(surface));
    double volume = 0;
    for (const auto& c : cells.vertices) {
        const auto p = [&](std::size_t i) { return points[static_cast<std::size_t>(c[i])]; };
        const double v = cell_moment(p(0), p(1), p(2), p(3)).volume;
        CHECK(v > 0);
        volume += v;
    }
    CHECK(enclosed_volume(surface) == Approx(volume).epsilon(1e-12));
}

TEST_CASE("cells that name no vertex or share a facet three times are refused", "[motion][cells]") {
    CHECK_THROWS_AS(linked({{0, 1, 2, 4}}, 4), Error);
    CHECK_THROWS_AS(linked({{0, 1, -1, 3}}, 4), Error);
    CHECK_THROWS_AS(linked({{7, 8, 9, 10}}, 4), Error);
    CHECK_THROWS_AS(linked({{0, 1, 2, 3}, {0, 2, 1, 4}, {0, 1, 2, 5}}, 6), Error);
}

TEST_CASE("the circumcentre of a tetrahedron is as far from all corners", "[motion][cells]") {
    const auto points = random_points(400, 4);
    for (std::size_t i = 0; i + 3 < points.size(); i += 4) {
        const auto [w, volume] = cell_moment(points[i], points[i + 1], points[i + 2], points[i + 3]);
        Coordinates<3> c;
        for (std::size_t k = 0; k < 3; ++k) c[k] = points[i][k] + w[k] / volume;
        const auto r = [&](std::size_t j) {
            return std::hypot(points[j][0] - c[0], points[j][1] - c[1], points[j][2] - c[2]);
        };
        for (std::size_t j = i + 1; j < i + 4; ++j)
            CHECK(r(j) == Approx(r(i)).epsilon(1e-6 / std::min(1.0, std::abs(volume))));
    }
}

TEST_CASE("dihedral angles of known tetrahedra", "[motion][cells]") {
    const auto degrees = [](const std::array<double, 6>& cosines) {
        std::vector<double> d;
        for (const double c : cosines) d.push_back(std::acos(c) * 180 / std::numbers::pi);
        std::sort(d.begin(), d.end());
        return d;
    };
    const auto regular = degrees(dihedral_cosines({1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}));
    for (const double d : regular) CHECK(d == Approx(70.528779365509308));
    const auto corner = degrees(dihedral_cosines({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
    for (std::size_t i = 0; i < 3; ++i) CHECK(corner[i] == Approx(54.735610317245346));
    for (std::size_t i = 3; i < 6; ++i) CHECK(corner[i] == Approx(90.0));
    // The other way round: the same.
    CHECK(degrees(dihedral_cosines({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1})) == corner);
}
