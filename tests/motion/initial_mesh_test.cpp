// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/error.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/cells_3.h>
#include <apps/motion/initial_mesh_3.h>
#include <apps/motion/surface_3.h>

#include <support/catch.h>

#include <cmath>
#include <set>

using namespace annulus;
using namespace annulus_test;

namespace {

double far(const Coordinates<3>& a, const Coordinates<3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Volume of the cells whose circumcentre is in the domain.
double meshed_volume(const Domain_3& domain, const std::vector<Coordinates<3>>& points) {
    Options options;
    options.strategy = Strategy::rebuild;
    const Mesh_cells<3> cells = linked(Moving_delaunay_3(points, options).audit_input().cells, points.size());
    const auto inside = cells_inside(domain, cells, points);
    double sum = 0;
    for (std::size_t c = 0; c < cells.vertices.size(); ++c) {
        const auto at = [&](std::size_t i) { return points[static_cast<std::size_t>(cells.vertices[c][i])]; };
        if (inside[c] != 0) sum += cell_moment(at(0), at(1), at(2), at(3)).volume;
    }
    return sum;
}

}  // namespace

TEST_CASE("a mesh of a ball has about as many vertices as asked, in the ball", "[motion][mesh]") {
    const Ball_3 ball(1);
    const auto points = initial_mesh(ball, Sizing_3(ball), 1200, 1);
    CHECK(std::abs(static_cast<double>(points.size()) - 1200) < 60);
    CHECK(std::set<Coordinates<3>>(points.begin(), points.end()).size() == points.size());
    std::size_t on_surface = 0;
    for (const auto& p : points) {
        const double r = far(p, {});
        CHECK(r < 1 + 1e-9);
        on_surface += r > 1 - 1e-9;
    }
    CHECK(on_surface > 200);
    CHECK(on_surface < 800);
    CHECK(meshed_volume(ball, points) == Approx(ball.volume()).epsilon(0.05));
    CHECK(points == initial_mesh(ball, Sizing_3(ball), 1200, 1));
}

TEST_CASE("a mesh of a surface that is not convex fills it", "[motion][mesh]") {
    const Surface_3 surface(dented());
    const auto points = initial_mesh(surface, Sizing_3(surface), 800, 2);
    CHECK(std::abs(static_cast<double>(points.size()) - 800) < 60);
    for (const auto& p : points) CHECK((surface.contains_by_ray(p) || far(surface.project(p), p) < 1e-9));
    CHECK(meshed_volume(surface, points) == Approx(surface.volume()).epsilon(0.08));
}

TEST_CASE("a graded mesh is coarser in the depth", "[motion][mesh]") {
    const Ball_3 ball(1);
    const auto deep = [](const std::vector<Coordinates<3>>& points) {
        std::size_t n = 0;
        for (const auto& p : points) n += far(p, {}) < 0.6;
        return static_cast<double>(n) / static_cast<double>(points.size());
    };
    const auto constant = initial_mesh(ball, Sizing_3(ball), 1000, 1),
               graded = initial_mesh(ball, Sizing_3(ball, 3), 1000, 1);
    CHECK(deep(graded) < 0.5 * deep(constant));
}

TEST_CASE("refinement ends beside sharp edges, and where it would need too much", "[motion][mesh]") {
    // Mesh_3 refined for ever for angles here.
    const Surface_3 sharp({{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 4}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}});
    const auto points = initial_mesh(sharp, Sizing_3(sharp), 600, 1);
    CHECK(std::abs(static_cast<double>(points.size()) - 600) < 60);
    // A plate a millionth as thick as wide: at the size that its volume suggests it would have too many vertices.
    const Surface_3 plate(box({1, 1, 1e-6}));
    try {
        const auto p = initial_mesh(plate, Sizing_3(plate), 20, 1);
        CHECK(p.size() < 2200);
    } catch (const Error& e) {
        CHECK((e.code() == Error_code::too_few || e.code() == Error_code::bad_input));
    }
}

TEST_CASE("fewer than four vertices are no mesh", "[motion][mesh]") {
    const Ball_3 ball(1);
    CHECK_THROWS_AS(initial_mesh(ball, Sizing_3(ball), 3, 1), Error);
}
