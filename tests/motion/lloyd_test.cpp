// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours_of.h"
#include "oracle.h"
#include "some_domain.h"

#include <annulus/error.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/sampling_2.h>
#include <apps/motion/voronoi_cell_2.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace annulus;
using annulus::testing::for_all;

namespace {

using Points = std::vector<Coordinates<2>>;

/// Sum over the cells of the integral of density times square distance to the site: formula (5) of the paper.
double energy(const Domain_2& domain, Density density, const Points& points) {
    const Neighbours_2 neighbours = neighbours_of(points);
    Voronoi_cell_2 cell_of(domain);
    oracle::Real sum = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        const Cell_2& cell = cell_of(points[v], neighbours.of(v), points, neighbours.hull[v] == 0);
        Points offsets;
        for (const Corner_2& corner : cell.corners) {
            REQUIRE_FALSE(corner.arc);
            offsets.push_back(corner.offset);
        }
        sum += oracle::polygon(density, cell.origin, offsets, density == Density::sin2 ? 0.5L : 1e9L).second;
    }
    return static_cast<double>(sum);
}

}  // namespace

TEST_CASE("a square lattice in its square is a fixed point of uniform Lloyd", "[motion][lloyd]") {
    const int k = 12;
    Points points;
    for (int i = 0; i < k; ++i)
        for (int j = 0; j < k; ++j) points.push_back({(2 * i + 1 - k) / 2.0, (2 * j + 1 - k) / 2.0});
    Points target(points.size());
    const Lloyd_2 lloyd(Domain_2::square(k / 2.0), Density::one);
    const Lloyd_step step = lloyd.step(neighbours_of(points), points, target);
    CHECK(step.max_displacement < 1e-14);
    CHECK(step.kept == 0);
}

TEST_CASE("the interior of a hexagonal lattice is a fixed point of uniform Lloyd", "[motion][lloyd]") {
    Points points;
    for (int i = -12; i <= 12; ++i)
        for (int j = -12; j <= 12; ++j) points.push_back({i + j * 0.5, j * std::sqrt(0.75)});
    Points target(points.size());
    (void)Lloyd_2(Domain_2::disc(8), Density::one).step(neighbours_of(points), points, target);
    std::size_t interior = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (std::hypot(points[v][0], points[v][1]) > 7) continue;
        ++interior;
        CHECK(std::hypot(target[v][0] - points[v][0], target[v][1] - points[v][1]) < 1e-14);
    }
    CHECK(interior > 100);
}

TEST_CASE("Lloyd iterations never increase the energy and stay in the domain", "[motion][lloyd]") {
    const int which = GENERATE(1, 2);
    const std::uint64_t seed = 7;
    const Domain_2 domain = some_domain(which);
    for (const Density density : all_densities) {
        CAPTURE(seed, which, std::string(name_of(density)));
        Points points = sample(domain, density, 60, seed), target(points.size());
        const Lloyd_2 lloyd(domain, density);
        double before = energy(domain, density, points);
        for (int iteration = 0; iteration < 8; ++iteration) {
            const Lloyd_step step = lloyd.step(neighbours_of(points), points, target);
            CHECK(step.max_displacement >= step.mean_displacement);
            for (const auto& p : target) REQUIRE(domain.contains(p));
            points = target;
            const double after = energy(domain, density, points);
            CHECK(after < before);
            before = after;
        }
    }
}

TEST_CASE("a target is the centroid of the nearest part of the domain", "[motion][lloyd]") {
    // By counting: a fine grid of the domain, each grid point given to its nearest site.
    for (const int which : {0, 1, 2})
        for (const Density density : all_densities) {
            const std::uint64_t seed = 21;
            CAPTURE(seed, which, std::string(name_of(density)));
            const Domain_2 domain = some_domain(which);
            const Points points = sample(Domain_2::disc(9), Density::one, 12, seed);
            Points target(points.size());
            (void)Lloyd_2(domain, density).step(neighbours_of(points), points, target);
            std::vector<oracle::Moments> sums(points.size());
            const int fine = 700;
            for (int i = 0; i < fine; ++i)
                for (int j = 0; j < fine; ++j) {
                    const Coordinates<2> p{-12 + 24 * (i + 0.5) / fine, -12 + 24 * (j + 0.5) / fine};
                    if (!domain.contains(p)) continue;
                    std::size_t nearest = 0;
                    double best = 1e9;
                    for (std::size_t v = 0; v < points.size(); ++v) {
                        const double d = std::hypot(p[0] - points[v][0], p[1] - points[v][1]);
                        if (d < best) best = d, nearest = v;
                    }
                    const auto w = oracle::density(density, p[0], p[1]);
                    sums[nearest].mass += w, sums[nearest].x += w * p[0], sums[nearest].y += w * p[1];
                }
            for (std::size_t v = 0; v < points.size(); ++v) {
                if (sums[v].mass == 0) continue;
                CHECK(std::abs(target[v][0] - sums[v].x / sums[v].mass) < 0.02);
                CHECK(std::abs(target[v][1] - sums[v].y / sums[v].mass) < 0.02);
            }
        }
}

TEST_CASE("the result does not depend on the number of threads, bit for bit", "[motion][lloyd]") {
    const std::uint64_t seed = 3;
    const Domain_2 disc = Domain_2::disc(40);
    const Points points = sample(disc, Density::one, 5000, seed);
    const Neighbours_2 neighbours = neighbours_of(points);
    for (const Density density : all_densities) {
        CAPTURE(seed, std::string(name_of(density)));
        Points one(points.size()), other(points.size());
        const Lloyd_step expected = Lloyd_2(disc, density, 1).step(neighbours, points, one);
        // Many times, because the assignment of work to threads varies.
        for (int turn = 0; turn < 40; ++turn) {
            const int threads = 2 + turn % 3;
            const Lloyd_step got = Lloyd_2(disc, density, threads).step(neighbours, points, other);
            CHECK(other == one);
            CHECK(got.mean_displacement == expected.mean_displacement);
            CHECK(got.max_displacement == expected.max_displacement);
            CHECK(got.kept == expected.kept);
        }
    }
}

TEST_CASE("few, collinear, cocircular, free and outside points work", "[motion][lloyd]") {
    const Lloyd_2 disc(Domain_2::disc(2), Density::one), square(Domain_2::square(3), Density::one);
    const auto targets = [](const Lloyd_2& lloyd, const Points& points, std::size_t kept = 0) {
        Points target(points.size());
        const Lloyd_step step = lloyd.step(neighbours_of(points), points, target);
        CHECK(step.kept == kept);
        for (const auto& p : target) CHECK((kept > 0 || lloyd.domain().contains(p)));
        return target;
    };
    const auto is = [](const Coordinates<2>& a, const Coordinates<2>& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1]) < 1e-14;
    };
    CHECK(targets(disc, {}).empty());
    CHECK(is(targets(disc, {{1, 0.5}})[0], {0, 0}));
    CHECK(is(targets(square, {{50, 70}})[0], {0, 0}));
    const Points halves = targets(square, {{-1, 0}, {1, 0}});
    CHECK(is(halves[0], {-1.5, 0}));
    CHECK(is(halves[1], {1.5, 0}));
    const double half_disc = 4 * 2 / (3 * 3.14159265358979323846);
    CHECK(is(targets(disc, {{0, -1}, {0, 1}})[1], {0, half_disc}));
    const Points line = targets(square, {{-2, 0}, {0, 0}, {2, 0}, {-1, 0}, {1, 0}});  // collinear, not in order
    CHECK(is(line[0], {-2.25, 0}));
    CHECK(is(line[1], {0, 0}));
    CHECK(is(line[3], {-1, 0}));
    CHECK(is(targets(square, {{-1, 0}, {5, 0}, {100, 0}}, 1)[2], {100, 0}));  // no part of the square is nearest
    Points ring{{0, 0}};                                                      // cocircular and exact
    for (const auto& p : Points{{3, 4}, {4, 3}, {5, 0}, {4, -3}, {3, -4}, {0, -5}, {-3, -4}, {-5, 0}, {-3, 4}, {0, 5}})
        ring.push_back({p[0] / 4, p[1] / 4});
    for (const auto& p : targets(disc, ring)) CHECK(std::isfinite(p[0]));
    // Free: index 1 has no neighbours.
    Neighbours_2 neighbours = neighbours_of({{-1, 0}, {1, 0}});
    neighbours.begin = {0, 1, 1, 2};
    neighbours.vertex = {2, 0};
    neighbours.hull = {1, 1, 1};
    Points with_gap{{-1, 0}, {99, 99}, {1, 0}}, target(3);
    const Lloyd_step step = square.step(neighbours, with_gap, target);
    CHECK(target[1] == with_gap[1]);
    CHECK(is(target[0], {-1.5, 0}));
    CHECK(step.mean_displacement == Approx(0.5));
    CHECK(step.kept == 0);
}

TEST_CASE("nearly flat triangles and wrong stars still give targets in the domain", "[motion][lloyd]") {
    CHECK(for_all("targets are finite and in the domain whatever the lists and however degenerate the points", [] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        const auto kind = *rc::gen::inRange(0, 4);
        std::mt19937_64 random(seed);
        const auto unit = [&] { return static_cast<double>(random()) * 0x1p-64; };
        const Domain_2 domain = some_domain(static_cast<int>(random() % 3));
        Points points;
        for (int i = 0; i < 80; ++i) {
            const double x = 8 * unit() - 4, y = 8 * unit() - 4;
            if (kind == 0) points.push_back({x, 1e-12 * y});                          // nearly a line
            if (kind == 1) points.push_back({std::round(2 * x), std::round(2 * y)});  // grid
            if (kind == 2) points.push_back({1e-9 * x + 3, 1e-9 * y + 1});            // a clump
            if (kind == 3) points.push_back({x, y});
        }
        std::sort(points.begin(), points.end());
        points.erase(std::unique(points.begin(), points.end()), points.end());
        const Neighbours_2 neighbours = neighbours_of(points);
        if (kind == 3) std::shuffle(points.begin(), points.end(), random);  // lists of other points
        Points target(points.size());
        for (const Density density : all_densities) {
            (void)Lloyd_2(domain, density).step(neighbours, points, target);
            // A vertex outside of the domain stays there when its cell does not reach the domain.
            for (std::size_t v = 0; v < points.size(); ++v)
                RC_ASSERT(domain.contains(target[v]) || target[v] == points[v]);
            if (kind != 3) {
                Points sorted = target;
                std::sort(sorted.begin(), sorted.end());
                RC_ASSERT(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
            }
        }
    }));
}

TEST_CASE("wrong sizes and thread counts are refused", "[motion][lloyd]") {
    const Lloyd_2 lloyd(Domain_2::disc(1), Density::one);
    Points points{{0, 0}, {0.5, 0}}, target(1);
    CHECK_THROWS_AS(lloyd.step(neighbours_of(points), points, target), Error);
    CHECK_THROWS_AS(Lloyd_2(Domain_2::disc(1), Density::one, 0), Error);
}
