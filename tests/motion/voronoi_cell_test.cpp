// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours_of.h"
#include "some_domain.h"

#include <apps/motion/moments_2.h>
#include <apps/motion/sampling_2.h>
#include <apps/motion/voronoi_cell_2.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace annulus;
using annulus::testing::for_all;

using Points = std::vector<Coordinates<2>>;

TEST_CASE("Voronoi cells in the domain add up to the domain", "[motion][cell]") {
    CHECK(for_all("masses of all cells sum to the mass of the domain, for every density", [] {
        const auto seed = *rc::gen::arbitrary<std::uint32_t>();
        const auto n = *rc::gen::inRange<std::size_t>(1, 300);
        const auto which = *rc::gen::inRange(0, 3);
        const Domain_2 domain = some_domain(which);
        // Some points are outside of the domain.
        const Points points = sample(Domain_2::disc(13), Density::one, n, seed);
        const Neighbours_2 neighbours = neighbours_of(points);
        Voronoi_cell_2 cell_of(domain);
        for (const Density density : all_densities) {
            const Cell_2 whole = domain.whole({0, 0});
            const double mass = moments(density, whole.origin, whole.corners).mass;
            double sum = 0;
            for (std::size_t v = 0; v < n; ++v) {
                const Cell_2& cell = cell_of(points[v], neighbours.of(v), points, neighbours.hull[v] == 0);
                const double part = moments(density, cell.origin, cell.corners).mass;
                RC_ASSERT(part >= -1e-13 * mass);
                sum += part;
            }
            RC_ASSERT(std::abs(sum - mass) < 1e-11 * mass);
        }
    }));
}

TEST_CASE("the direct path and clipping by bisectors give the same cell", "[motion][cell]") {
    const std::uint64_t seed = GENERATE(1u, 2u);
    CAPTURE(seed);
    const Domain_2 disc = Domain_2::disc(56);
    const Points points = sample(disc, Density::one, 2000, seed);
    const Neighbours_2 neighbours = neighbours_of(points);
    Voronoi_cell_2 direct(disc), clipped(disc);
    std::size_t compared = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (neighbours.hull[v] != 0) continue;
        const Cell_2 a = direct(points[v], neighbours.of(v), points, true);
        const Cell_2 b = clipped(points[v], neighbours.of(v), points, false);
        const Moments_2 ma = moments(Density::one, a.origin, a.corners),
                        mb = moments(Density::one, b.origin, b.corners);
        double size = 0;
        for (const Corner_2& corner : a.corners) size = std::max(size, std::hypot(corner.offset[0], corner.offset[1]));
        CHECK(std::abs(ma.mass - mb.mass) < 1e-12 * size * size);
        CHECK(std::hypot(ma.first[0] - mb.first[0], ma.first[1] - mb.first[1]) < 1e-12 * size * size * size);
        compared += a.corners.size() == b.corners.size();
    }
    CHECK(compared > 1800);
}

TEST_CASE("clipping a small cell out of a large domain keeps the small cell's accuracy", "[motion][cell]") {
    const Domain_2 disc = Domain_2::disc(1e6);
    const double h = 1e-3, turn = 0.3;
    Points points{{1000, 500}};
    for (int i = 0; i < 5; ++i)
        points.push_back({1000 + h * std::cos(turn + 1.2 * i), 500 + (h + 1e-4 * i) * std::sin(turn + 1.2 * i)});
    const std::vector<Index> around{1, 2, 3, 4, 5};
    Voronoi_cell_2 cell_of(disc);
    const Cell_2 clipped = cell_of(points[0], around, points, false);
    REQUIRE(clipped.corners.size() == 5);
    for (const Corner_2& corner : clipped.corners) {
        // As far from the site as from two neighbours.
        const auto [x, y] = corner.offset;
        int equal = 0;
        for (std::size_t v = 1; v < points.size(); ++v) {
            const double dx = points[v][0] - points[0][0], dy = points[v][1] - points[0][1];
            const double excess = x * dx + y * dy - (dx * dx + dy * dy) / 2;
            CHECK(excess < 1e-14 * h * h);
            equal += std::abs(excess) < 1e-14 * h * h;
        }
        CHECK(equal == 2);
    }
}
