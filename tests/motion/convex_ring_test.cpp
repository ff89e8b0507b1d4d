// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/convex_ring_2.h>
#include <apps/motion/domain_2.h>
#include <apps/motion/moments_2.h>

#include <support/catch.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace annulus;

namespace {

using Points = std::vector<Coordinates<2>>;
using Whole = std::array<std::int64_t, 2>;

std::int64_t turn(const Whole& a, const Whole& b, const Whole& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Corners of the convex hull, counter-clockwise, the smallest first; in integers, by Andrew's monotone chain.
std::vector<Whole> hull_of(std::vector<Whole> points) {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Whole> hull;
    const auto chain = [&](auto begin, auto end) {
        const std::size_t base = hull.size();
        for (auto p = begin; p != end; ++p) {
            while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
            hull.push_back(*p);
        }
        hull.pop_back();
    };
    chain(points.begin(), points.end());
    chain(points.rbegin(), points.rend());
    return hull;
}

/// The same polygon in another form: from another corner, the other way round, with corners in the middle of edges (for
/// even coordinates one such corner is exact), repeated corners, closed.
Points rewritten(const std::vector<Whole>& hull, std::mt19937_64& random) {
    std::vector<Whole> list;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Whole& a = hull[i];
        const Whole& b = hull[(i + 1) % hull.size()];
        list.push_back(a);
        if (random() % 3 == 0) list.push_back({(a[0] + b[0]) / 2, (a[1] + b[1]) / 2});
    }
    std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(random() % list.size()), list.end());
    if (random() % 2 == 0) std::reverse(list.begin(), list.end());
    Points written;
    for (const Whole& c : list)
        for (std::uint64_t k = 0; k <= (random() % 4 == 0 ? random() % 3 : 0); ++k)
            written.push_back({static_cast<double>(c[0]), static_cast<double>(c[1])});
    for (std::uint64_t k = random() % 3; k > 0; --k) written.push_back(written.front());
    return written;
}

std::string refusal(const Points& corners, std::size_t at) {
    try {
        (void)convex_ring(corners);
    } catch (const Corner_error& error) {
        CHECK(error.code() == Error_code::bad_input);
        CHECK(error.corner() == at);
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST_CASE("a polygon is the same bits however its corners are listed, and has its exact area and centroid",
          "[motion][domain]") {
    const std::uint64_t seed = 26;
    CAPTURE(seed);
    std::mt19937_64 random(seed);
    for (int round = 0; round < 2000; ++round) {
        std::vector<Whole> cloud;
        const std::uint64_t n = 3 + random() % 12;
        const auto size = static_cast<std::int64_t>(1 + random() % 2000);
        for (std::uint64_t i = 0; i < n; ++i)
            cloud.push_back({2 * (static_cast<std::int64_t>(random() % 4001) % (2 * size + 1) - size),
                             2 * (static_cast<std::int64_t>(random() % 4001) % (2 * size + 1) - size)});
        const std::vector<Whole> hull = hull_of(cloud);
        if (hull.size() < 3) continue;
        Points expected;
        for (const Whole& c : hull) expected.push_back({static_cast<double>(c[0]), static_cast<double>(c[1])});
        const Points written = rewritten(hull, random);
        CAPTURE(round, written);
        const Domain_2 domain = Domain_2::polygon(written);
        REQUIRE(Points(domain.corners().begin(), domain.corners().end()) == expected);
        // Exact: six times the area times the centroid, and twice the area, from the first corner.
        std::int64_t area = 0, x = 0, y = 0;
        for (std::size_t i = 1; i + 1 < hull.size(); ++i) {
            const std::int64_t a = turn(hull[0], hull[i], hull[i + 1]);
            area += a;
            x += a * (hull[i][0] + hull[i + 1][0] - 2 * hull[0][0]);
            y += a * (hull[i][1] + hull[i + 1][1] - 2 * hull[0][1]);
        }
        REQUIRE(domain.area() == Approx(static_cast<double>(area) / 2).epsilon(1e-14));
        const Cell_2 whole = domain.whole(expected[0]);
        const Moments_2 m = moments(Density::one, whole.origin, whole.corners);
        const double width = 4.0 * static_cast<double>(size);
        REQUIRE(m.first[0] / m.mass ==
                Approx(static_cast<double>(x) / (3 * static_cast<double>(area))).margin(1e-14 * width));
        REQUIRE(m.first[1] / m.mass ==
                Approx(static_cast<double>(y) / (3 * static_cast<double>(area))).margin(1e-14 * width));
    }
}

TEST_CASE("a closed ring is the open one", "[motion][domain]") {
    const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Points rings[] = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}},
                            {{0, 0}, {0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0, 0}, {-0.0, 0}},
                            {{1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}},
                            {{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}},              // clockwise
                            {{0.5, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {0.5, 0}},  // within an edge
                            {{0, 0}, {0.25, 0}, {0.5, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0.5}, {0, 0}},
                            // Nearly repeated.
                            {{0, 0}, {1, 0}, {1, 1e-30}, {1, 1}, {0, 1}, {1e-25, 0}}};
    for (const Points& ring : rings) {
        CAPTURE(ring);
        CHECK(convex_ring(ring) == square);
    }
    CHECK(convex_ring(Points{{3, 1}, {1, 2}, {1, 1}, {3, 1}}) == Points{{1, 1}, {3, 1}, {1, 2}});
}

TEST_CASE("corners that rounding has put beside an edge are no corners, those outside of it are kept",
          "[motion][domain]") {
    // Tenths of a unit on two slanted edges: rounding puts most off them, on either side.
    const Coordinates<2> corners[] = {{0, 0}, {1, 0.3}, {0.7, 1.3}};
    Points ring;
    for (std::size_t e = 0; e < 3; ++e)
        for (int k = 0; k < 10; ++k) {
            const auto& a = corners[e];
            const auto& b = corners[(e + 1) % 3];
            ring.push_back({a[0] + (b[0] - a[0]) * k / 10, a[1] + (b[1] - a[1]) * k / 10});
        }
    const Points kept = convex_ring(ring);
    for (const auto& c : corners) CHECK(std::find(kept.begin(), kept.end(), c) != kept.end());
    const Domain_2 domain = Domain_2::polygon(ring);
    for (const auto& c : ring) CHECK(domain.contains(c));
    CHECK(domain.area() == Approx(0.5 * (1 * 1.3 - 0.3 * 0.7)).epsilon(1e-15));
    const double u = std::numeric_limits<double>::epsilon();
    CHECK(convex_ring(Points{{0, 0}, {1, -u / 1024}, {2, 0}, {1, 1}}).size() == 4);  // flat, and turns
    CHECK(convex_ring(Points{{0, 0}, {1, u / 1024}, {2, 0}, {1, 1}}).size() == 3);
    // Far from the origin rounding is larger.
    const Points utm{{5e6, 5e6}, {5e6 + 1, 5e6 + 0x1p-30}, {5e6 + 2, 5e6}, {5e6 + 1, 5e6 + 1}};
    CHECK(convex_ring(utm).size() == 3);
}

TEST_CASE("what is no convex polygon is refused at its corner, in words that are true", "[motion][domain]") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THAT(refusal({}, 0), contains("different ones here: 0"));
    CHECK_THAT(refusal({{0, 0}, {1, 0}, {0, 0}}, 0), contains("different ones here: 2"));
    CHECK_THAT(refusal(Points(4, {0, 0}), 0), contains("all its 4 are at one place"));
    CHECK_THAT(refusal(Points(4, {3, -2}), 0), contains("all its 4 are at one place"));
    CHECK_THAT(refusal({{0, 0}, {1, 1}, {3, 3}, {2, 2}, {0, 0}}, 0), contains("all its 5 are on one line"));
    CHECK_THAT(refusal({{0, 0}, {0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}}, 0), contains("on one line"));  // not exactly
    CHECK_THAT(refusal({{0, 0}, {1, 0}, {1, nan}}, 2), contains("finite"));
    CHECK_THAT(refusal({{0, 0}, {1e101, 0}, {0, 1}}, 0), contains("between 1e-100 and 1e100"));
    // The corner is counted in the list, with its repeated and flat ones.
    CHECK_THAT(refusal({{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 0}}, 5),
               contains("counter-clockwise and turns right at corner 5"));
    CHECK_THAT(refusal({{2, 2}, {1, 0.5}, {2, 0}, {0, 0}}, 1), contains("clockwise and turns left at corner 1"));
    CHECK_THAT(refusal({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3), contains("turns right"));  // an L
    // Spikes: outwards, inwards, along an edge, at the ends of the list.
    CHECK_THAT(refusal({{0, 0}, {1, 0}, {1, 0.5}, {2, 0.5}, {1, 0.5}, {1, 1}, {0, 1}}, 3),
               contains("go back on itself"));
    CHECK_THAT(refusal({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, 1), contains("go back on itself"));
    CHECK_THAT(refusal({{0, 0}, {2, 0}, {1, 0}, {3, 0}, {1, 1}}, 1), contains("go back on itself"));
    CHECK_THAT(refusal({{1, 0}, {1, 1}, {0, 0}, {1, 0}, {2, 0}}, 4), contains("go back on itself"));
    // A spike along an edge that rounding has put beside it.
    CHECK_THAT(refusal({{0, 0}, {0.7, 0.21 + 1e-17}, {0.3, 0.09}, {1, 0.3}, {0, 1}}, 2), contains("corner"));
    Points star;
    for (int i = 0; i < 5; ++i)
        star.push_back({std::cos(4 * std::numbers::pi / 5 * i), std::sin(4 * std::numbers::pi / 5 * i)});
    CHECK_THROWS_WITH(convex_ring(star), contains("go around once"));
    CHECK_THROWS_AS(convex_ring(Points{{0, 0}, {1, 1}, {1, 0}, {0, 1}}), Corner_error);  // crosses itself
    Points twice{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 1}, {0, 1}};
    CHECK_THROWS_AS(convex_ring(twice), Corner_error);
}
