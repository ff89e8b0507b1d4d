// SPDX-License-Identifier: GPL-3.0-or-later
#include "nodt_cases.h"
#include "shapes.h"

#include <annulus/error.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/dihedral.h>
#include <apps/motion/initial_mesh_3.h>
#include <apps/motion/nodt_3.h>
#include <apps/motion/surface_3.h>
#include <apps/motion/surface_stars.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>

using namespace annulus;
using namespace annulus_test;

TEST_CASE("the body-centred lattice is a fixed point, and locks where its angles say", "[motion][nodt]") {
    const Points points = body_centred(5, 0.18);
    const Ball_3 ball(0.9);
    const Mesh_cells<3> cells = cells_of(points);
    const auto inside = cells_inside(ball, cells, points);
    Points target(points.size());
    (void)Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
    std::size_t interior = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (distance(points[v], {}) > 0.65) continue;
        ++interior;
        CHECK(distance(points[v], target[v]) < 1e-14);
    }
    CHECK(interior > 200);

    // Its dihedral angles are 60 and 90 degrees.
    Points moved = points;
    const std::size_t spoilt =
        static_cast<std::size_t>(std::find(points.begin(), points.end(), Coordinates<3>{}) - points.begin());
    REQUIRE(spoilt < points.size());
    moved[spoilt] = {0.006, 0.004, 0.002};
    const Mesh_cells<3> after = cells_of(moved);
    const auto inside_after = cells_inside(ball, after, moved);
    const Nodt_step all =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points), 59.9).step(after, inside_after, moved, target);
    std::set<Index> near;
    for (const auto& c : after.vertices)
        if (std::find(c.begin(), c.end(), static_cast<Index>(spoilt)) != c.end()) near.insert(c.begin(), c.end());
    std::size_t locked = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (distance(points[v], {}) > 0.65) continue;
        locked += target[v] == moved[v];
        // A neighbour with a spoilt cell is unlocked and moves; all others rest.
        CHECK((target[v] == moved[v]) == !near.contains(static_cast<Index>(v)));
    }
    CHECK(locked + near.size() == interior);
    CHECK(all.locked >= locked);
    // 30 degrees leave room for the move.
    const Nodt_step loose =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points), 30).step(after, inside_after, moved, target);
    CHECK(loose.locked > all.locked);
    CHECK(target[spoilt] == moved[spoilt]);
}

TEST_CASE("a free vertex goes where the energy of its star is least", "[motion][nodt]") {
    // The energy of natural ODT is the integral of the interpolation of |x|² on the mesh; of a fixed domain and
    // connectivity.
    const Ball_3 ball(1);
    for (unsigned seed = 20; seed < 24; ++seed) {
        Points points;
        for (const auto& p : random_points(700, seed)) points.push_back(ball.contains(p) ? p : ball.project(p));
        const Mesh_cells<3> cells = cells_of(points);
        const auto inside = cells_inside(ball, cells, points);
        Points target(points.size());
        (void)Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
        std::set<Index> boundary;
        for (const auto& facet : surface_facets(cells, inside)) boundary.insert(facet.begin(), facet.end());
        std::size_t checked = 0;
        for (std::size_t v = 0; v < points.size(); ++v) {
            std::vector<std::array<Index, 4>> star;
            bool interior = !boundary.contains(static_cast<Index>(v));
            for (std::size_t c = 0; c < cells.vertices.size(); ++c)
                if (std::find(cells.vertices[c].begin(), cells.vertices[c].end(), static_cast<Index>(v)) !=
                    cells.vertices[c].end()) {
                    star.push_back(cells.vertices[c]);
                    interior = interior && inside[c] != 0;
                }
            if (!interior || target[v] == points[v]) continue;
            const auto energy = [&](const Coordinates<3>& x) {
                Real sum = 0;
                for (const auto& cell : star) {
                    std::array<Coordinates<3>, 4> q;
                    Real height = 0;
                    for (std::size_t i = 0; i < 4; ++i) {
                        q[i] = cell[i] == static_cast<Index>(v) ? x : points[static_cast<std::size_t>(cell[i])];
                        height += dot(minus(q[i], {}), minus(q[i], {}));
                    }
                    sum += height / 4 * dot(minus(q[1], q[0]), cross(minus(q[2], q[0]), minus(q[3], q[0]))) / 6;
                }
                return sum;
            };
            // A quadratic function of x: equal on both sides of its least value, and larger there.
            const Real least = energy(target[v]);
            for (std::size_t k = 0; k < 3; ++k) {
                Coordinates<3> a = target[v], b = target[v];
                a[k] += 0.01;
                b[k] -= 0.01;
                CHECK(energy(a) > least);
                CHECK(std::abs(static_cast<double>((energy(a) - energy(b)) / (energy(a) - least))) < 1e-8);
            }
            ++checked;
        }
        CHECK(checked > 100);
    }
}

TEST_CASE("rows of a regular lattice that go against each other are damped", "[motion][nodt]") {
    const double off = 0.02;
    const Surface_3 surface(box({6, 6, 1}));
    Points points;
    for (int row = -3; row <= 3; ++row)
        for (int k = -4; k <= 4; ++k)
            points.push_back({row % 2 == 0 ? k : k + 0.5, std::sqrt(0.75) * row + (row % 2 == 0 ? off : -off), 1});
    const std::size_t middle = points.size() / 2;
    points.push_back({0, 0, -1});
    const Mesh_cells<3> cells = cells_of(points);
    Points target(points.size());
    (void)Nodt_3(surface, Sizing_3(surface), vertices_on_surface(surface, points))
        .step(cells, std::vector<char>(cells.vertices.size(), 1), points, target);
    // The mean is the mirror image of the position; the target is three quarters of the way there.
    CHECK(distance(points[middle], {0, off, 1}) < 1e-15);
    CHECK(distance(target[middle], {0, -off / 2, 1}) < 1e-12);
}

TEST_CASE("graded sizing pulls vertices towards where edges are to be short", "[motion][nodt]") {
    const Points points = body_centred(5, 0.18);
    const Ball_3 ball(0.9);
    const Mesh_cells<3> cells = cells_of(points);
    Points target(points.size());
    (void)Nodt_3(ball, Sizing_3(ball, 3), vertices_on_surface(ball, points))
        .step(cells, cells_inside(ball, cells, points), points, target);
    std::size_t counted = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        const double r = distance(points[v], {});
        if (r > 0.6 || r < 0.2) continue;
        ++counted;
        CHECK(distance(target[v], {}) > r + 1e-4);
    }
    CHECK(counted > 100);
}

TEST_CASE("natural ODT does not depend on threads", "[motion][nodt]") {
    const Surface_3 surface(box({1, 0.8, 0.6}));
    Points points;
    for (const auto& p : random_points(3000, 7)) points.push_back(surface.contains(p) ? p : surface.project(p));
    const Mesh_cells<3> cells = cells_of(points);
    Points one(points.size()), three(points.size());
    const auto a = cells_inside(surface, cells, points, 1), b = cells_inside(surface, cells, points, 3);
    CHECK(a == b);
    const Nodt_step s = Nodt_3(surface, Sizing_3(surface, 1), vertices_on_surface(surface, points), 20.0, 1)
                            .step(cells, a, points, one);
    const Nodt_step t = Nodt_3(surface, Sizing_3(surface, 1), vertices_on_surface(surface, points), 20.0, 3)
                            .step(cells, b, points, three);
    CHECK(one == three);
    CHECK(s.mean_displacement == t.mean_displacement);
    CHECK(s.locked == t.locked);
}

TEST_CASE("targets never coincide, even when all of them are pulled to one place", "[motion][nodt]") {
    struct Trap final : Domain_3 {  // every projection ends in one point
        [[nodiscard]] bool contains(const Coordinates<3>& p) const override { return distance(p, {}) < 5; }
        using Domain_3::project;
        [[nodiscard]] Coordinates<3> project(const Coordinates<3>&) const override { return {1, 0, 0}; }
        [[nodiscard]] std::optional<Coordinates<3>> crossing(const Coordinates<3>&,
                                                             const Coordinates<3>&) const override {
            return std::nullopt;
        }
        [[nodiscard]] std::vector<Coordinates<3>> surface_sample(std::size_t, std::uint64_t) const override {
            return {};
        }
        [[nodiscard]] Box bounding_box() const override { return {}; }
        [[nodiscard]] double volume() const override { return 1; }
    };
    const Trap trap;
    Points points = round_octahedron(1).points;
    points.push_back({0.1, 0, 0});
    const Mesh_cells<3> cells = cells_of(points);
    Points target(points.size());
    std::vector<char> on_surface(points.size(), 1);
    on_surface.back() = 0;
    const Nodt_step step =
        Nodt_3(trap, Sizing_3(trap), on_surface).step(cells, cells_inside(trap, cells, points), points, target);
    CHECK(std::set<Coordinates<3>>(target.begin(), target.end()).size() == points.size());
    CHECK(step.kept >= step.boundary - 1);
}

TEST_CASE("natural ODT refuses arrays that do not fit and angles that lock everything", "[motion][nodt]") {
    const Ball_3 ball(1);
    const Points points = round_octahedron(0).points;
    const Mesh_cells<3> cells = cells_of(points);
    Points target(points.size()), small(2);
    const auto inside = cells_inside(ball, cells, points);
    const Nodt_3 nodt(ball, Sizing_3(ball), std::vector<char>(6));
    CHECK_THROWS_AS(nodt.step(cells, inside, points, small), Error);
    CHECK_THROWS_AS(nodt.step(cells, std::vector<char>(1), points, target), Error);
    CHECK_THROWS_AS(Nodt_3(ball, Sizing_3(ball), {}, 71.0), Error);
    CHECK_THROWS_AS(Nodt_3(ball, Sizing_3(ball), {}, 0.0), Error);
    CHECK_THROWS_AS(Nodt_3(ball, Sizing_3(ball), {}, {}, 0), Error);
}
