// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/kept_cells_3.h>
#include <apps/motion/nodt_3.h>
#include <apps/motion/surface_3.h>

#include <support/catch.h>

#include <algorithm>
#include <bit>
#include <random>

using namespace annulus;
using namespace annulus_test;

namespace {

using Points = std::vector<Coordinates<3>>;

Moving_delaunay_3 kept(const Points& points) {
    return Moving_delaunay_3(points, Options{.strategy = Strategy::tolerances});
}

/// The cells in their order, by sorting all of them and linking by a map of facets.
Mesh_cells<3> cells_of(const Moving_delaunay_3& dt) {
    Mesh_cells<3> out;
    out.vertices = dt.audit_input().cells;
    for (auto& c : out.vertices) c = in_order(c);
    std::sort(out.vertices.begin(), out.vertices.end());
    std::vector<std::array<Index, 5>> facets;  // sorted corners, cell, slot
    for (std::size_t c = 0; c < out.vertices.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i) {
            std::array<Index, 3> f{};
            for (std::size_t k = 0; k < 3; ++k) f[k] = out.vertices[c][(i + k + 1) % 4];
            std::sort(f.begin(), f.end());
            facets.push_back({f[0], f[1], f[2], static_cast<Index>(c), static_cast<Index>(i)});
        }
    std::sort(facets.begin(), facets.end());
    out.neighbours.assign(out.vertices.size(), {out.outside, out.outside, out.outside, out.outside});
    for (std::size_t k = 0; k + 1 < facets.size(); ++k) {
        const auto &f = facets[k], &g = facets[k + 1];
        if (!std::equal(f.begin(), f.begin() + 3, g.begin())) continue;
        out.neighbours[static_cast<std::size_t>(f[3])][static_cast<std::size_t>(f[4])] = g[3];
        out.neighbours[static_cast<std::size_t>(g[3])][static_cast<std::size_t>(g[4])] = f[3];
    }
    return out;
}

void check_same(const Kept_cells_3& got, const Mesh_cells<3>& expected) {
    REQUIRE((got.cells().vertices == expected.vertices));
    REQUIRE((got.cells().neighbours == expected.neighbours));
}

bool same_bits(std::span<const Cell_moment> a, std::span<const Cell_moment> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& p, const auto& q) { return p.moment == q.moment && p.volume == q.volume; });
}

/// Moves all points in random directions, by this much at most.
void shake(Points& points, double most, std::mt19937_64& random) {
    for (auto& p : points)
        for (double& x : p) x += most * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
}

}  // namespace

TEST_CASE("cells kept from step to step are those of a new triangulation, in the same order", "[motion][cells]") {
    std::mt19937_64 random(3);
    Points points = random_points(500, 3);
    Moving_delaunay_3 dt = kept(points);
    Kept_cells_3 cells;
    for (int step = 0; step < 50; ++step) {
        CAPTURE(step);
        cells.read(dt.mesh().table(), 1 + step % 3);
        check_same(cells, cells_of(dt));
        Kept_cells_3 listed;
        listed.read(dt.audit_input().cells, points.size(), 1 + step % 2);
        check_same(listed, cells_of(dt));
        shake(points, step % 10 == 9 ? 0.05 : 0.0005, random);  // sometimes too many differ to be merged
        (void)dt.move_all(points);
    }
}

TEST_CASE("kept cells follow vertices that come and go, hull and all", "[motion][cells]") {
    const Points points = random_points(300, 9);
    Moving_delaunay_3 dt = kept(points);
    Kept_cells_3 cells;
    for (std::size_t i = 0; i < 40; ++i) {
        CAPTURE(i);
        const Coordinates<3>& p = points[i];
        if (i % 4 == 3) (void)dt.insert(Moving_delaunay_3::Point(3 * p[0], p[1], p[2]));
        else if (i % 4 == 1) (void)dt.move(static_cast<Index>(i), {p[0] + 0.01, p[1], p[2]});
        cells.read(dt.mesh().table());
        check_same(cells, cells_of(dt));
    }
}

TEST_CASE("what is kept of cells at rest is what measuring them again gives", "[motion][cells]") {
    std::mt19937_64 random(4);
    const Ball_3 ball(0.8), other(0.5);
    Points points = random_points(800, 4);
    Moving_delaunay_3 dt = kept(points);
    Kept_cells_3 cells;
    for (int step = 0; step < 30; ++step) {
        CAPTURE(step);
        const Ball_3& domain = step < 25 ? ball : other;
        cells.read(dt.mesh().table());
        cells.measure(domain, dt.positions(), 1 + step % 3);
        Kept_cells_3 fresh;
        fresh.read(dt.mesh().table());
        fresh.measure(domain, dt.positions());
        REQUIRE(cells.inside() == fresh.inside());
        REQUIRE(same_bits(cells.moments(), fresh.moments()));
        REQUIRE((cells.inside() == cells_inside(domain, cells.cells(), dt.positions(), 2)));
        Points moved = points;
        shake(moved, 0.002, random);
        for (std::size_t v = 0; v < points.size(); ++v)
            if (step % 3 != 2 && v % 5 == 0) points[v] = moved[v];
        (void)dt.move_all(points);
    }
}

TEST_CASE("natural ODT with a memory does what it does without, in any number of threads", "[motion][nodt]") {
    const Ball_3 ball(1);
    const Surface_3 surface(round_octahedron(2));
    const Domain_3& domain = GENERATE(0, 1) == 0 ? static_cast<const Domain_3&>(ball) : surface;
    Points points = domain.surface_sample(700, 6);
    for (const auto& p : random_points(1500, 6))
        if (domain.contains(p)) points.push_back(p);
    const auto on_surface = vertices_on_surface(domain, points);
    for (const double gradation : {0.0, 1.0}) {
        Points x = points;
        Moving_delaunay_3 dt = kept(x);
        Kept_cells_3 cells[3];
        Nodt_memory memory[3];
        const int threads[3] = {1, 2, 5};
        for (int step = 0; step < 8; ++step) {
            CAPTURE(gradation, step);
            Points expected(x.size());
            Kept_cells_3 fresh;
            fresh.read(dt.mesh().table());
            fresh.measure(domain, dt.positions());
            const Nodt_step one = Nodt_3(domain, Sizing_3(domain, gradation), on_surface, 20.0, 1)
                                      .step(fresh.cells(), fresh.inside(), dt.positions(), expected);
            for (std::size_t k = 0; k < 3; ++k) {
                Points target(x.size());
                cells[k].read(dt.mesh().table(), threads[k]);
                cells[k].measure(domain, dt.positions(), threads[k]);
                const Nodt_step got = Nodt_3(domain, Sizing_3(domain, gradation), on_surface, 20.0, threads[k])
                                          .step(cells[k], dt.positions(), target, memory[k]);
                CHECK((target == expected));
                CHECK(got.mean_displacement == one.mean_displacement);
                CHECK(got.max_displacement == one.max_displacement);
                CHECK(got.locked == one.locked);
                CHECK(got.kept == one.kept);
            }
            for (std::size_t v = 0; v < x.size(); ++v)
                if (step % 4 != 3 && x[v][0] > 0) x[v] = expected[v];
            (void)dt.move_all(x);
        }
    }
}
