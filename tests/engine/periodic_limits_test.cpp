// SPDX-License-Identifier: GPL-3.0-or-later
// What moves of periodic meshes cost, and what becomes of them beyond the limits of engine/periodic_repair.cpp and
// periodic_motion.cpp: other boxes, rounds, the budget. Always the cells of a fresh build.
#include <annulus/error.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/periodic_boxes.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Positions = std::vector<Coordinates<d>>;

template <int d>
Box<d> cube(double edge) {
    Coordinates<d> lengths;
    lengths.fill(edge);
    return Box<d>::orthorhombic(lengths);
}

template <int d>
void expect_as_built(const Periodic_mesh<d>& mesh, std::span<const Coordinates<d>> x, const Box<d>& box) {
    CHECK(cells_of(mesh) == cells_of(Periodic_mesh<d>(x, box)));
    CHECK(mesh.audit().delaunay());
}

template <int d>
Positions<d> jittered(Periodic_cases& cases, Positions<d> x, double most) {
    for (auto& p : x)
        for (double& c : p) c += cases.uniform(-most, most);
    return x;
}

/// The counted cost of a build at these points: that of a move to a box twice as large, which no flips are tried for.
template <int d>
double cost_of_build(const Positions<d>& x) {
    Positions<d> large = x;
    for (auto& p : large)
        for (double& c : p) c *= 2;
    Periodic_mesh<d> mesh(large, cube<d>(2));
    const Move_result result = mesh.move_all(x, cube<d>(1));
    CHECK(result.moves.rebuilt == x.size());
    CHECK(result.statistics.cost > 0);
    return result.statistics.cost;
}

/// Steps of all sizes: up to the budget, and beyond it.
template <int d>
void expect_budget_kept(std::size_t n, double large) {
    CAPTURE(d, n);
    Periodic_cases cases(n);
    const Positions<d> x = cases.points<d>(cube<d>(1), n, 1);
    const double build = cost_of_build<d>(x), limit = 8000 + build;
    const double copies = build / (d == 2 ? 36 : 80);
    CHECK(copies == std::floor(copies));
    CHECK(copies >= static_cast<double>(n));
    double most_repaired = 0;
    int rebuilt = 0;
    for (double spacings = 0.01; spacings < large; spacings *= 1.3) {
        CAPTURE(spacings);
        const Positions<d> y = jittered<d>(cases, x, spacings * std::pow(static_cast<double>(n), -1.0 / d));
        Periodic_mesh<d> mesh(x, cube<d>(1));
        const Move_result result = mesh.move_all(y);
        expect_as_built<d>(mesh, y, cube<d>(1));
        const double cost = result.statistics.cost;
        if (result.moves.rebuilt == 0) most_repaired = std::max(most_repaired, cost);
        else {
            ++rebuilt;
            CHECK(cost > cost_of_build<d>(y));
            CHECK(cost < cost_of_build<d>(y) + 1.1 * limit);
        }
    }
    CAPTURE(most_repaired, limit);
    CHECK(most_repaired > 0.3 * limit);
    CHECK(most_repaired < 1.1 * limit);
    CHECK(rebuilt > 0);
}

/// Points that come together to within a few units of the grid, and go back.
template <int d>
void expect_cluster_as_built(std::size_t n, std::size_t together, double units) {
    CAPTURE(d, n, together, units);
    Periodic_cases cases(together);
    const Positions<d> x = cases.points<d>(cube<d>(1), n, 1);
    Periodic_mesh<d> mesh(x, cube<d>(1));
    Positions<d> y = x;
    for (std::size_t k = 0; k < together; ++k)
        for (std::size_t i = 0, left = k; i < d; ++i, left /= 2)
            y[k][i] = 0.375 + units * static_cast<double>(i + 1 < d ? left % 2 : left) * mesh.grid()[i];
    mesh.move_all(y);
    expect_as_built<d>(mesh, y, cube<d>(1));
    mesh.move_all(x);
    expect_as_built<d>(mesh, x, cube<d>(1));
    y[1] = y[0];
    const auto before = mesh.cells();
    CHECK_THROWS_AS(mesh.move_all(y), Error);
    CHECK(mesh.cells().vertices == before.vertices);
    expect_as_built<d>(mesh, x, cube<d>(1));
}

}  // namespace

TEST_CASE("Periodic moves cost no more than their budget, and a build at most", "[engine][periodic]") {
    expect_budget_kept<2>(400, 2);
    expect_budget_kept<3>(60, 2);
    expect_budget_kept<3>(5, 8);
}

TEST_CASE("A box whose basis is more than eight old vectors away leads to a rebuild", "[engine][periodic]") {
    // In the old basis the first vector is about (k, 1), and the second (-1, 0), which has determinant 1.
    const auto moved = [](double k) {
        const Box<2> from({{{0.15, 0}, {0, 1}}}), to({{{0.15 * k, 1.18}, {-0.18, 0.19}}});
        Periodic_cases cases(8);
        const Positions<2> x = cases.points<2>(from, 7), y = cases.points<2>(to, 7);
        Periodic_mesh<2> mesh(x, from), other(x, cube<2>(1));
        const double cost = mesh.move_all(y, to).statistics.cost;
        expect_as_built<2>(mesh, y, to);
        return cost - other.move_all(y, to).statistics.cost;  // of what was tried before a build
    };
    CHECK(moved(8.4) != 0);
    CHECK(moved(8.6) == 0);
}

TEST_CASE("Periodic points come together to within units of the grid", "[engine][periodic]") {
    for (const double units : {1.0, 1000.0})
        for (const std::size_t together : {2U, 4U, 7U}) {
            expect_cluster_as_built<2>(40, together, units);
            expect_cluster_as_built<3>(40, together, units);
        }
}

TEST_CASE("Small periodic steps in 2D never rebuild, though a vertex may get through in small parts only",
          "[engine][periodic]") {
    for (const std::uint64_t seed : {89U, 148U, 0U, 1U, 2U, 3U}) {  // with 3 rounds in place of 24 the first two do
        CAPTURE(seed);
        Periodic_cases cases(seed);
        constexpr std::size_t n = 1000;
        const Positions<2> x = cases.points<2>(cube<2>(1), n, 1);
        Periodic_mesh<2> mesh(x, cube<2>(1));
        CHECK(mesh.move_all(jittered<2>(cases, x, 0.04 / std::sqrt(n))).moves.rebuilt == 0);
    }
}
