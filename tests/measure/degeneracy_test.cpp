// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>
#include <annulus/moving_mesh.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/point_sets_3.h>
#include <support/repeats.h>

#include <cmath>
#include <numbers>
#include <set>

using namespace annulus;
using namespace annulus::testing;

namespace {

Degeneracy of(const std::vector<Coordinates<2>>& x) {
    Delaunay_mesh<2> e;
    e.build(x);
    REQUIRE(e.dimension() == 2);
    return degeneracy(e.table(), x);
}
Degeneracy of(const std::vector<Coordinates<3>>& x) {
    Delaunay_mesh<3> e;
    e.build(x);
    REQUIRE(e.dimension() == 3);
    return degeneracy(e.table(), x);
}

using Below = std::vector<std::uint64_t>;

}  // namespace

TEMPLATE_TEST_CASE_SIG("Degeneracy of a mesh is that of its cells, dimension", "[measure][degeneracy]", ((int d), d), 2,
                       3) {
    std::vector<Coordinates<d>> x;
    for (std::size_t i = 0; i < 60; ++i) {
        auto& p = x.emplace_back();
        for (std::size_t c = 0; c < d; ++c) p[c] = double((i * (7 + 4 * c * c) + i / 5) % 13);
        p[0] += double(i) / 64;
    }
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const Degeneracy found = degeneracy(mesh);
    const Degeneracy expected = degeneracy(mesh.mesh().table(), mesh.points());
    CHECK(found.dimension == d);
    CHECK(found.bicells.least.total > 0);
    CHECK(found.bicells.least.total == expected.bicells.least.total);
    CHECK(found.bicells.least.below == expected.bicells.least.below);
    CHECK(found.vertices.total == x.size());

    const std::vector<Coordinates<d>> line{{0, 0}, {1, 1}, {2, 2}};
    CHECK_THROWS_AS(degeneracy(Moving_mesh<d>(std::span<const Coordinates<d>>(line))), Error);
}

TEST_CASE("a grid: every diagonal is cocircular, every straight hull vertex collinear", "[measure][degeneracy]") {
    const std::size_t n = 7;
    std::vector<Coordinates<2>> x;
    for (std::size_t i = 0; i < n * n; ++i) x.push_back({double(i % n), double(i / n)});
    const Degeneracy d = of(x);
    const std::uint64_t squares = (n - 1) * (n - 1);
    CHECK(d.spacing == Approx(std::sqrt(double(squares) / double(n * n))).epsilon(1e-14));
    CHECK(d.resolution == 0x1p-50);  // 6 is between 4 and 8
    CHECK(d.cells.least.total == 2 * squares);
    CHECK(d.cells.least.zero == 0);
    CHECK(d.cells.least.below == Below(5, 0));
    CHECK(d.bicells.least.total == squares + 2 * (n - 1) * (n - 2));
    CHECK(d.bicells.least.zero == squares);
    CHECK(d.bicells.least.below == Below(5, squares));
    CHECK(d.bicells.decided_exactly == squares);
    CHECK(d.ridges.least.total == 4 * (n - 1));
    CHECK(d.ridges.least.zero == 4 * (n - 2));
    CHECK(d.vertices.total == n * n);
    CHECK(d.vertices.zero == n * n);
    CHECK(d.vertices.paper_above_exact == 0);
    CHECK(d.vertices.paper_unsound == 0);
    CHECK(d.non_convex == 0);
    CHECK(d.bicells.arithmetic.total() == d.bicells.least.total);
    CHECK(d.bicells.arithmetic.exact >= squares);
    // Two triangles that share a side of the grid: the annulus through (0, 0), (1, 0) and (0, 1), (1, -1) or (0, 1),
    // (0, -1).
    CHECK(d.bicells.least.width.quantiles.back() > 0.1);
    CHECK(d.theta.histogram.total() == d.bicells.least.total);
}

TEST_CASE("three collinear points in a bi-cell are flat, not reflex", "[measure][degeneracy]") {
    // The facet (0, 0) (0, 2) between (-3, 0) and (3, 0), and a reflex one where the facet is moved up.
    CHECK(of(std::vector<Coordinates<2>>{{0, 0}, {0, 2}, {-3, 0}, {3, 0}}).flat == 1);
    CHECK(of(std::vector<Coordinates<2>>{{0, 0}, {0, 2}, {-3, 0}, {3, 0}}).non_convex == 0);
    const Degeneracy d = of(std::vector<Coordinates<2>>{{0, 0.5}, {0, 2}, {-3, 0}, {3, 0}});
    CHECK(d.flat == 0);
    CHECK(d.bicells.least.total == 3);
    CHECK(d.non_convex == 3);
}

TEST_CASE("a cube: its bi-cells are cospherical, its faces' diagonals coplanar", "[measure][degeneracy]") {
    std::vector<Coordinates<3>> x;
    for (int i = 0; i < 8; ++i) x.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    const Degeneracy d = of(x);
    CHECK(d.spacing == Approx(0.5).epsilon(1e-14));
    CHECK(d.bicells.least.zero == d.bicells.least.total);
    CHECK(d.standard.zero == d.standard.total);
    CHECK(d.ridges.least.total == 18);  // twelve triangles
    CHECK(d.ridges.least.zero == 6);
    CHECK(d.cells.least.zero == 0);
    CHECK(d.vertices.zero == 8);
    CHECK(d.vertices.paper_unsound == 0);
}

TEST_CASE("the spindle: the paper's tolerance is unsound at all five points", "[measure][degeneracy]") {
    const double h = std::sqrt(0.75);
    const Degeneracy d =
        of(std::vector<Coordinates<3>>{{0, 0, 0.99}, {0, 0, -0.99}, {1, 0, 0}, {-0.5, h, 0}, {-0.5, -h, 0}});
    CHECK(d.bicells.least.total == 3);
    CHECK(d.cells.least.total == 3);
    CHECK(d.ridges.least.total == 9);
    // docs/theory.md 3: half widths 0.005 and 0.00748.
    CHECK(d.bicells.least.width.quantiles.front() * d.spacing == Approx(0.01).epsilon(1e-9));
    CHECK(d.standard.width.quantiles.front() * d.spacing == Approx(2 * 0.00748).epsilon(1e-3));
    CHECK(d.non_convex == 3);
    CHECK(d.vertices.paper_unsound == 5);
    CHECK(d.vertices.paper_above_exact == 5);
    CHECK(d.vertices.unsound_certificates == 3);
}

TEST_CASE("a regular tetrahedron and its centre", "[measure][degeneracy]") {
    const Degeneracy d = of(std::vector<Coordinates<3>>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0, 0, 0}});
    CHECK(d.spacing == Approx(std::cbrt(8.0 / 15)).epsilon(1e-14));
    CHECK(d.bicells.least.total == 6);
    CHECK(d.non_convex == 6);  // reflex at the centre
    CHECK(d.flat == 0);
    CHECK(d.theta.quantiles.front() == Approx(std::numbers::pi / 2));
    CHECK(d.cells.least.total == 4);
    // The altitude of a cell over its outer facet is 1 / sqrt(3); of the others, and between opposite edges, it is
    // more.
    CHECK(d.cells.least.width.quantiles.front() * d.spacing == Approx(1 / std::sqrt(3)).epsilon(1e-9));
    CHECK(d.ridges.least.total == 6);
    CHECK(d.ridges.least.width.quantiles.front() == d.ridges.least.width.quantiles.back());
    CHECK(d.ridges.least.width.quantiles.front() * d.spacing == Approx(2).epsilon(1e-9));  // between opposite edges
    CHECK(d.bicells.least.zero + d.cells.least.zero + d.ridges.least.zero + d.vertices.zero == 0);
    CHECK(d.bicells.arithmetic.total() == 6);
}

TEST_CASE("counts of nearly degenerate points are those of real numbers", "[measure][degeneracy]") {
    // A square with one corner moved by e: half the width is e / (4 sqrt 2), to first order.
    for (const int k : {-4, -12, -22, -32, -42, -51}) {
        const double e = std::ldexp(1.0, k);
        const Degeneracy d = of(std::vector<Coordinates<2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1 + e}});
        CHECK(d.bicells.least.total == 1);
        CHECK(d.bicells.least.zero == 0);
        const double width = e / std::sqrt(8);
        Below expected;
        for (const Threshold& t : d.thresholds) expected.push_back(width < t.width ? 1 : 0);
        CHECK(d.bicells.least.below == expected);
        CHECK(d.bicells.least.width.quantiles[0] * d.spacing == Approx(width).epsilon(0.1));
    }
}

TEST_CASE("counts do not depend on the unit of length if it is a power of two", "[measure][degeneracy]") {
    Random random(7);
    const auto json = [](const Degeneracy& d) {
        std::vector<double> all;
        for (const auto* c : {&d.bicells.least, &d.standard, &d.cells.least, &d.ridges.least}) {
            all.insert(all.end(), {double(c->total), double(c->zero)});
            all.insert(all.end(), c->below.begin(), c->below.end());
        }
        const Vertex_counts& v = d.vertices;
        all.insert(all.end(), v.below.begin(), v.below.end());
        all.insert(all.end(), {double(v.zero), double(v.paper_above_exact), double(v.paper_unsound),
                               double(d.non_convex), double(d.flat)});
        return all;
    };
    for (const Set_3 set : {Set_3::uniform, Set_3::lattice, Set_3::slivers, Set_3::near_sphere}) {
        const Points_3 x = point_set(set, 60, random);
        const Degeneracy here = of(x);
        for (const int k : {-300, -3, 20, 400}) {
            Points_3 y = x;
            for (auto& p : y)
                for (double& c : p) c = std::ldexp(c, k);
            const Degeneracy there = of(y);
            CHECK(there.spacing ==
                  Approx(std::ldexp(here.spacing, k)).epsilon(1e-13));  // cells may come in another order
            CHECK(json(there) == json(here));
        }
    }
}

TEST_CASE("in the plane the paper's tolerance is sound", "[measure][degeneracy]") {
    Random random(13);
    for (const Family family : all_families) {
        const Points x = point_set(family, 120, random);
        Delaunay_mesh<2> e;
        e.build(x);
        if (e.dimension() < 2) continue;
        INFO(name_of(family));
        const Degeneracy d = degeneracy(e.table(), x);
        CHECK(d.vertices.paper_unsound == 0);
        CHECK(d.vertices.unsound_certificates == 0);
        CHECK(d.vertices.total == x.size());
    }
}
