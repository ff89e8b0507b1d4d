// SPDX-License-Identifier: GPL-3.0-or-later
// Natural ODT at the surface of a domain.
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

TEST_CASE("boundary vertices stay on the surface, symmetric ones where they are", "[motion][nodt]") {
    Points points = round_octahedron(0).points;
    points.push_back({0, 0, 0});
    const Ball_3 ball(1);
    const Mesh_cells<3> cells = cells_of(points);
    Points target(points.size());
    const auto inside = cells_inside(ball, cells, points);
    const Nodt_step step =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
    CHECK(step.boundary == 6);
    CHECK(step.vertices == 7);
    for (std::size_t v = 0; v < points.size(); ++v) CHECK(distance(target[v], points[v]) < 1e-15);
}

TEST_CASE("which vertices are on the surface", "[motion][nodt]") {
    const Surface_3 surface(box({1, 0.8, 0.6}));
    const Coordinates<3> on_a_face = surface.project({0.1, 0.1, 0.2}), on_another = surface.project({0.7, 0.1, 0.2});
    const Points points{
        on_a_face, {0.1, 0.1, 0.2}, on_another, {0.1, 0.1, on_a_face[2] + 1e-12}, {0.1, 0.1, on_a_face[2] + 1e-6}};
    const auto on = vertices_on_surface(surface, points);
    for (std::size_t v = 0; v < points.size(); ++v)
        CHECK((on[v] != 0) == (distance(points[v], surface.project(points[v])) < 1e-8));
    CHECK(std::count(on.begin(), on.end(), 1) > 0);
    CHECK(std::count(on.begin(), on.end(), 0) > 0);
}

TEST_CASE("the facets around a vertex are a disc or not", "[motion][nodt]") {
    const Triangle_surface octahedron = round_octahedron(0);
    std::vector<std::array<Index, 3>> facets(octahedron.triangles.begin(), octahedron.triangles.end());
    REQUIRE(facets.size() == 8);
    {
        const Surface_stars stars(facets, 7);
        for (Index v = 0; v < 6; ++v) {
            CHECK(stars.around(v).size() == 4);
            CHECK(stars.disc(v));
        }
        CHECK_FALSE(stars.disc(6));  // no facets
    }
    {
        // A second one that shares a vertex with the first: two fans there.
        auto both = facets;
        for (auto f : facets) {
            for (Index& v : f)
                if (v != facets[0][0]) v += 6;
            both.push_back(f);
        }
        const Surface_stars stars(both, 12);
        for (const auto& f : both)
            for (const Index v : f) CHECK(stars.disc(v) == (v != facets[0][0]));
    }
    {
        const auto lost = facets.back();
        facets.pop_back();
        const Surface_stars stars(facets, 6);
        for (Index v = 0; v < 6; ++v) CHECK(stars.disc(v) == (std::find(lost.begin(), lost.end(), v) == lost.end()));
    }
    // Three sheets along an edge; two of them are a disc around its ends, the third is too much.
    const Surface_stars book(
        std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 4}, {0, 4, 5}, {0, 5, 1}}, 6);
    CHECK_FALSE(book.disc(0));
}

TEST_CASE("vertices of the surface go by a tenth of the way to their nearest neighbour", "[motion][nodt]") {
    Points points = round_octahedron(2).points;
    points.push_back({0, 0, 0});
    points[0] = Ball_3(1).project({points[0][0] + 0.3, points[0][1] + 0.1, points[0][2] - 0.2});
    const Ball_3 ball(1);
    const Mesh_cells<3> cells = cells_of(points);
    const auto inside = cells_inside(ball, cells, points);
    Points target(points.size());
    const Nodt_step step =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
    CHECK(step.boundary + 1 == points.size());
    std::size_t full = 0;
    const auto facets = surface_facets(cells, inside);
    for (std::size_t v = 0; v + 1 < points.size(); ++v) {
        double nearest = 10;
        for (const auto& f : facets)
            if (std::find(f.begin(), f.end(), static_cast<Index>(v)) != f.end())
                for (const Index w : f)
                    if (w != static_cast<Index>(v))
                        nearest = std::min(nearest, distance(points[v], points[static_cast<std::size_t>(w)]));
        const double went = distance(points[v], target[v]);
        CHECK(went <= 0.1 * nearest * 1.01);  // the projection to the surface is added
        full += went > 0.07 * nearest;
    }
    CHECK(full > 0);
}

TEST_CASE("vertices of the surface do not exchange their places for ever", "[motion][nodt]") {
    const Ball_3 ball(1);
    Points points = round_octahedron(3).points;
    const Points noise = random_points(points.size(), 5);
    for (std::size_t v = 0; v < points.size(); ++v) {
        for (std::size_t k = 0; k < 3; ++k) points[v][k] += 1e-3 * noise[v][k];
        points[v] = ball.project(points[v]);
    }
    points.push_back({0, 0, 0});
    const Mesh_cells<3> cells = cells_of(points);
    const auto inside = cells_inside(ball, cells, points);
    const Nodt_3 nodt(ball, Sizing_3(ball), vertices_on_surface(ball, points));
    Points before, target(points.size());
    double there = 0, and_back = 0;
    for (int step = 0; step < 40; ++step) {
        (void)nodt.step(cells, inside, points, target);
        there = and_back = 0;
        for (std::size_t v = 0; v < points.size(); ++v) {
            there += distance(points[v], target[v]);
            if (step > 0) and_back += distance(before[v], target[v]);
        }
        before = points;
        points = target;
    }
    CHECK(and_back > 1.5 * there);  // on the way to rest: two steps are nearly twice as far as one
}

TEST_CASE("a tip of a surface stays where it is", "[motion][nodt]") {
    // A needle with twelve sides. Were its vertex drawn to the mean of its facets' circumcentres, it would slide down
    // the side.
    Triangle_surface needle;
    needle.points = {{0, 0, 4}, {0, 0, 0}};
    for (int i = 0; i < 12; ++i)
        needle.points.push_back({std::cos(std::numbers::pi * i / 6), std::sin(std::numbers::pi * i / 6), 0});
    for (Index i = 0; i < 12; ++i) {
        needle.triangles.push_back({0, 2 + i, 2 + (i + 1) % 12});
        needle.triangles.push_back({1, 2 + (i + 1) % 12, 2 + i});
    }
    const Surface_3 surface(needle);
    Points points = initial_mesh(surface, Sizing_3(surface), 400, 1);
    const auto from_tip = [&] {
        double nearest = 10;
        for (const auto& p : points) nearest = std::min(nearest, distance(p, {0, 0, 4}));
        return nearest;
    };
    const double before = from_tip();
    const Nodt_3 nodt(surface, Sizing_3(surface), vertices_on_surface(surface, points));
    for (int step = 0; step < 200; ++step) {
        const Mesh_cells<3> cells = cells_of(points);
        Points target(points.size());
        (void)nodt.step(cells, cells_inside(surface, cells, points), points, target);
        points = target;
    }
    INFO("from " << before << " to " << from_tip());
    CHECK(from_tip() < before + 0.1);
}

TEST_CASE("vertices on sharp edges stay on them, and corners where they are", "[motion][nodt][features]") {
    for (const double stretch : {1.0, 1.7}) {
        const Triangle_surface s = box({stretch, 0.8, 0.6});
        const Surface_3 surface(s);
        auto sharp = std::make_shared<const Feature_curves>(s, 30);
        Points points = initial_mesh(surface, Sizing_3(surface), 400, 1, sharp.get());
        sharp->snap(points, rounding_of(surface));
        const std::vector<Feature_curves::Place> place = sharp->places(points, rounding_of(surface));
        // Mesh_3 spaces them evenly.
        const Points noise = random_points(points.size(), 3);
        for (std::size_t v = 0; v < points.size(); ++v)
            if (const auto c = static_cast<Index>(place[v]); c >= 0) {
                const Polyline_3& curve = sharp->curves()[static_cast<std::size_t>(c)];
                points[v] = curve.at(curve.nearest(points[v]) + 0.03 * noise[v][0]);
            }
        const Points start = points;
        CHECK(std::count(place.begin(), place.end(), Feature_curves::Place::corner) == 8);
        const Nodt_3 nodt(surface, Sizing_3(surface), vertices_on_surface(surface, points), {}, 1,
                          Curve_motion(sharp, place));
        double gone = 0;
        for (int step = 0; step < 30; ++step) {
            const Mesh_cells<3> cells = cells_of(points);
            Points target(points.size());
            const Nodt_step done = nodt.step(cells, cells_inside(surface, cells, points), points, target);
            CHECK(done.kept >= 8);
            points = target;
        }
        for (std::size_t v = 0; v < points.size(); ++v) {
            if (place[v] == Feature_curves::Place::off) continue;
            int sides = 0, rests = 0;  // of the box, exactly
            for (std::size_t k = 0; k < 3; ++k) {
                sides += std::abs(points[v][k]) == s.points[7][k];
                rests += points[v][k] == start[v][k];
            }
            CHECK(sides >= (place[v] == Feature_curves::Place::corner ? 3 : 2));
            CHECK(rests >= sides);
            gone = std::max(gone, distance(points[v], start[v]));
        }
        CHECK(gone > 0.001);
        // Every edge of the box is edges of cells of the domain, end to end: its vertices in their order are joined.
        const Mesh_cells<3> cells = cells_of(points);
        const auto inside = cells_inside(surface, cells, points);
        std::set<std::set<Index>> edges;
        for (const auto& f : surface_facets(cells, inside))
            for (std::size_t i = 0; i < 3; ++i) edges.insert({f[i], f[(i + 1) % 3]});
        for (const Polyline_3& curve : sharp->curves()) {
            std::map<double, Index> along;
            for (std::size_t v = 0; v < points.size(); ++v)
                if (const double at = curve.nearest(points[v]); distance(curve.at(at), points[v]) < 1e-9)
                    along[at] = static_cast<Index>(v);
            REQUIRE(along.size() > 2);
            for (auto a = along.begin(), b = std::next(a); b != along.end(); ++a, ++b)
                CHECK(edges.contains({a->second, b->second}));
        }
    }
}
