// SPDX-License-Identifier: GPL-3.0-or-later
// Tolerances of degenerate points, each of which may take an exact evaluation: fifty times what the filter takes. What
// calls cost is counted, in rebuilds. No clock is read.
#include <annulus/engine/rebuild_policy.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include "../../bench/motions/families.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

using namespace annulus;

namespace {

/// What it costs, in rebuilds, to compute so many tolerances, so many of them exactly.
template <int d>
double in_rebuilds(std::uint64_t evaluated, std::uint64_t exact, std::size_t n) {
    const double each = Cost_model<d>::recomputation / Cost_model<d>::certificates;
    return (each * static_cast<double>(evaluated) + exact_evaluation_cost * static_cast<double>(exact)) /
           Rebuild_policy<d>::rebuild_cost(n);
}

/// Points of an integer lattice, from one corner on, and how many there are along an edge.
template <int d>
std::vector<Coordinates<d>> lattice(std::size_t edge) {
    std::vector<Coordinates<d>> x;
    std::size_t all = 1;
    for (int k = 0; k < d; ++k) all *= edge;
    for (std::size_t i = 0; i < all; ++i) {
        Coordinates<d>& p = x.emplace_back();
        std::size_t rest = i;
        for (double& c : p) {
            c = static_cast<double>(rest % edge);
            rest /= edge;
        }
    }
    return x;
}

template <int d>
Coordinates<d> moved(const Coordinates<d>& p, double way, bench::Random& random) {
    Coordinates<d> q = p;
    for (double& c : q) c += way * random.normal();
    return q;
}

}  // namespace

// A 64th of the points of a sphere or circle move on it: one by one.
TEMPLATE_TEST_CASE_SIG("No tolerances are computed of points in convex position that move by index, dimension",
                       "[engine]", ((int d), d), 2, 3) {
    constexpr std::size_t n = d == 2 ? 6400 : 2000, movers = n / 64;
    bench::Random random(5);
    bench::Points<d> x = bench::Scene<d>("sphere", "walk", n, 0.0, 1).points();
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
    for (int call = 0; call < 8; ++call) {
        std::vector<Index> indices;
        std::vector<Coordinates<d>> to;
        for (std::size_t k = 0; k < movers; ++k) {
            const auto v = static_cast<std::size_t>(random.bits() % n);
            Coordinates<d> p = moved<d>(x[v], 1e-5, random);
            double square = 0.0;
            for (const double c : p) square += c * c;
            for (double& c : p) c /= std::sqrt(square);
            indices.push_back(static_cast<Index>(v));
            to.push_back(x[v] = p);
        }
        const Move_result r = mesh.move(std::span<const Index>(indices), std::span<const Coordinates<d>>(to));
        CHECK(r.statistics.tolerance_recomputations == 0);
        REQUIRE(mesh.audit().delaunay());
    }
}

// All points are those of a lattice, but a few: tolerances pay where these move on, and all that are degenerate rest.
TEMPLATE_TEST_CASE_SIG(
    "No step of auto costs more than one and a half rebuilds on a lattice where few points move,"
    " dimension",
    "[engine]", ((int d), d), 2, 3) {
    const std::vector<Coordinates<d>> at_rest = lattice<d>(d == 2 ? 50 : 13);
    const std::size_t n = at_rest.size();
    std::vector<Coordinates<d>> x = at_rest;
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
    bench::Random random(3);
    for (int step = 0; step < 40; ++step) {
        CAPTURE(step);
        for (std::size_t v = 7; v < n; v += 100) x[v] = moved<d>(at_rest[v], 0.01, random);
        const Move_result r = mesh.move_all(std::span<const Coordinates<d>>(x));
        CHECK(r.statistics.cost <= 1.5 * Rebuild_policy<d>::rebuild_cost(n));
        REQUIRE(mesh.audit().delaunay());
    }
}

// Tolerances are there when a block of points comes to rest on a lattice, in one small step.
TEMPLATE_TEST_CASE_SIG("A part that becomes a lattice does not cost more than one and a half rebuilds, dimension",
                       "[engine]", ((int d), d), 2, 3) {
    constexpr double noise = 1e-3;
    const std::vector<Coordinates<d>> places = lattice<d>(d == 2 ? 50 : 13);
    const std::size_t n = places.size();
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        CAPTURE(seed);
        bench::Random random(seed);
        std::vector<Coordinates<d>> x;
        for (const Coordinates<d>& p : places) x.push_back(moved<d>(p, noise, random));
        Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
        bool kept = false;
        for (int step = 0; step < 60 && !kept; ++step) {
            for (std::size_t v = 7; v < n; v += d == 2 ? 100 : 500) x[v] = moved<d>(places[v], noise, random);
            const Move_result r = mesh.move_all(std::span<const Coordinates<d>>(x));
            CHECK(r.statistics.cost <= 1.5 * Rebuild_policy<d>::rebuild_cost(n));
            kept = r.statistics.tolerance_recomputations > 0;
        }
        REQUIRE(kept);
        std::copy_n(places.begin(), n / 12, x.begin());
        const Move_result r = mesh.move_all(std::span<const Coordinates<d>>(x));
        // Signs that are decided exactly have cost half a rebuild, in one, when it is known that flips do not pay.
        CHECK(r.statistics.cost <= 1.55 * Rebuild_policy<d>::rebuild_cost(n));
        REQUIRE(mesh.audit().delaunay());
    }
}

// The first cells and facets are those of a lattice: in the order of certificates the expensive ones come first.
TEMPLATE_TEST_CASE_SIG("Slices of tolerances end where later stages have cost as much as there is room for, dimension",
                       "[engine]", ((int d), d), 2, 3) {
    std::vector<Coordinates<d>> x = lattice<d>(d == 2 ? 9 : 5);
    const std::size_t degenerate = x.size(), n = degenerate * 24;
    bench::Random random(8);
    while (x.size() < n) {
        Coordinates<d>& p = x.emplace_back();
        for (double& c : p) c = 1000.0 + 30.0 * random.unit();
    }
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>{x});
    bool kept = false;
    std::vector<Move_result> sign_steps;
    for (int step = 0; step < 80; ++step) {
        CAPTURE(step);
        for (std::size_t v = degenerate; v < n; v += 100) x[v] = moved<d>(x[v], 0.001, random);
        const Move_result r = mesh.move_all(std::span<const Coordinates<d>>(x));
        CHECK(r.statistics.cost <= 1.5 * Rebuild_policy<d>::rebuild_cost(n));
        if (r.statistics.sign_steps > 0) sign_steps.push_back(r);
        kept = kept || r.statistics.tolerance_recomputations > 0;
        if (!kept || step % 8 == 0) REQUIRE(mesh.audit().delaunay());
    }
    CHECK(kept);
    // The first of them computes no tolerances, and the signs of all are about as many.
    REQUIRE(sign_steps.size() > 2);
    const auto& signs = sign_steps.front().statistics;
    for (const Move_result& r : sign_steps)
        CHECK(in_rebuilds<d>(
                  r.statistics.evaluated - std::min(signs.evaluated, r.statistics.evaluated),
                  r.statistics.arithmetic.exact - std::min(signs.arithmetic.exact, r.statistics.arithmetic.exact),
                  n) < 1.5);
}
