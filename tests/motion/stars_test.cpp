// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours_of.h"

#include <annulus/kernel/read_neighbours.h>
#include <annulus/moving_delaunay_2.h>
#include <apps/motion/domain_2.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/sampling_2.h>
#include <apps/motion/stars_2.h>

#include <support/catch.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace annulus;

namespace {

using Points = std::vector<Coordinates<2>>;

Moving_delaunay_2 kept(const Points& points) {
    return Moving_delaunay_2(points, Options{.strategy = Strategy::tolerances});
}

/// The lists from CGAL's triangulation of these points, in the order of Stars_2.
Stars_2 stars_of(const Points& points) {
    Stars_2 stars;
    stars.read(neighbours_of(points));
    return stars;
}

void check_same(const Stars_2& got, const Stars_2& expected) {
    REQUIRE(got.size() == expected.size());
    for (std::size_t v = 0; v < got.size(); ++v) {
        const auto a = got.of(v), b = expected.of(v);
        CAPTURE(v);
        REQUIRE(got.cyclic(v) == expected.cyclic(v));
        REQUIRE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
    }
}

/// Moves all points in random directions, by this much at most.
void shake(Points& points, double most, std::mt19937_64& random) {
    for (auto& p : points)
        for (double& x : p) x += most * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
}

}  // namespace

TEST_CASE("stars read off a table step by step are those of a new triangulation", "[motion][stars]") {
    const std::uint64_t seed = 5;
    std::mt19937_64 random(seed);
    Points points = sample(Domain_2::square(1), Density::one, 600, seed);
    Moving_delaunay_2 dt = kept(points);
    Stars_2 stars;
    std::size_t kept_lists = 0;
    for (int step = 0; step < 60; ++step) {
        CAPTURE(seed, step);
        const auto before = stars.readings();
        stars.read(dt.mesh().table());
        for (std::size_t v = 0; v < stars.size(); ++v) kept_lists += stars.since(v) <= before;
        check_same(stars, stars_of(points));
        shake(points, step % 10 == 9 ? 0.05 : 0.0005, random);  // sometimes nearly all lists change
        (void)dt.move_all(points);
    }
    CHECK(kept_lists > 30 * points.size());
}

TEST_CASE("stars follow vertices that come and go", "[motion][stars]") {
    const std::uint64_t seed = 6;
    Points points = sample(Domain_2::square(1), Density::one, 120, seed);
    Moving_delaunay_2 dt = kept(points);
    Stars_2 stars, whole;
    for (std::size_t i = 0; i < 40; ++i) {
        CAPTURE(i);
        if (i % 4 == 3) (void)dt.insert(Moving_delaunay_2::Point(points[i][0] + 0.01, points[i][1]));
        else dt.remove(dt.vertex(i));
        stars.read(dt.mesh().table());
        Neighbours_2 lists;
        read_neighbours(dt.mesh(), dt.positions(), lists);
        whole.read(lists);
        check_same(stars, whole);
    }
}

TEST_CASE("Lloyd with a memory does what Lloyd does without, in any number of threads", "[motion][stars][lloyd]") {
    const std::uint64_t seed = 8;
    const Domain_2 disc = Domain_2::disc(1);
    for (const Density density : all_densities) {
        std::mt19937_64 random(seed);
        Points points = sample(disc, density, 2000, seed);
        Moving_delaunay_2 dt = kept(points);
        const Lloyd_2 lloyd[] = {Lloyd_2(disc, density, 1), Lloyd_2(disc, density, 2), Lloyd_2(disc, density, 5)};
        Stars_2 stars[3];
        Lloyd_memory memory[3];
        for (int step = 0; step < 12; ++step) {
            CAPTURE(std::string(name_of(density)), step);
            Points expected(points.size());
            Stars_2 fresh;
            fresh.read(dt.mesh().table());
            Lloyd_memory fresh_memory;
            const Lloyd_step one = lloyd[0].step(fresh, dt.positions(), expected, fresh_memory);
            for (std::size_t k = 0; k < 3; ++k) {
                Points target(points.size());
                stars[k].read(dt.mesh().table());
                const Lloyd_step got = lloyd[k].step(stars[k], dt.positions(), target, memory[k]);
                CHECK((target == expected));
                CHECK(got.mean_displacement == one.mean_displacement);
                CHECK(got.max_displacement == one.max_displacement);
                CHECK(got.kept == one.kept);
            }
            // Only the vertices in a part of the domain move to their targets, so most rest; in some steps all rest, or
            // only stars change.
            for (std::size_t v = 0; v < points.size(); ++v)
                if (step % 5 != 4 && points[v][0] > 0.3) points[v] = expected[v];
            (void)dt.move_all(points);
        }
    }
}
