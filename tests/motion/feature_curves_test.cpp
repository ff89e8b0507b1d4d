// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/error.h>
#include <apps/motion/curve_motion.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <random>
#include <set>

using namespace annulus;
using namespace annulus_test;

namespace {

using Points = std::vector<Coordinates<3>>;
using Place = Feature_curves::Place;

/// An upright prism over a polygon that is star-shaped from its first corner.
Triangle_surface prism(const std::vector<Coordinates<2>>& polygon) {
    Triangle_surface s;
    const auto n = static_cast<Index>(polygon.size());
    for (const double z : {0.0, 1.0})
        for (const auto& p : polygon) s.points.push_back({p[0], p[1], z});
    for (Index i = 1; i + 1 < n; ++i) {
        s.triangles.push_back({0, i + 1, i});
        s.triangles.push_back({n, n + i, n + i + 1});
    }
    for (Index i = 0; i < n; ++i) {
        const Index j = (i + 1) % n;
        s.triangles.push_back({i, j, n + j});
        s.triangles.push_back({i, n + j, n + i});
    }
    return s;
}

std::vector<Coordinates<2>> circle(int n) {
    std::vector<Coordinates<2>> polygon;
    for (int i = 0; i < n; ++i)
        polygon.push_back({std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n)});
    return polygon;
}

double far(const Coordinates<3>& a, const Coordinates<3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

TEST_CASE("a box has twelve sharp edges and eight corners, each edge one curve", "[motion][features]") {
    const Triangle_surface s = box({1, 0.8, 0.6});
    const Feature_curves sharp(s, 89.9);
    CHECK(sharp.curves().size() == 12);
    CHECK(std::set<Coordinates<3>>(sharp.corners().begin(), sharp.corners().end()) ==
          std::set<Coordinates<3>>(s.points.begin(), s.points.end()));
    double sum = 0;
    for (std::size_t c = 0; c < 12; ++c) {
        CHECK_FALSE(sharp.goes_around(c));
        CHECK(sharp.curves()[c].points().size() == 2);  // diagonals of the faces are flat
        sum += sharp.curves()[c].length();
    }
    CHECK(sum == Approx(8 * (1 + 0.8 + 0.6)));
    const Feature_curves none_at_all(s, 90.1);
    CHECK(none_at_all.curves().empty());
    CHECK(none_at_all.corners().empty());
    for (const double angle : {0.0, 180.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS(Feature_curves(s, angle), Error);
}

TEST_CASE("valleys are sharp like ridges", "[motion][features]") {
    // The first corner is the inner one of an L.
    const Feature_curves sharp(prism({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}), 60);
    CHECK(sharp.curves().size() == 18);
    CHECK(sharp.corners().size() == 12);
}

TEST_CASE("the rims of a cylinder go around, and have no corner", "[motion][features]") {
    const Feature_curves sharp(prism(circle(48)), 30);
    CHECK(sharp.corners().empty());
    REQUIRE(sharp.curves().size() == 2);
    for (const std::size_t c : {std::size_t{0}, std::size_t{1}}) {
        const Polyline_3& rim = sharp.curves()[c];
        CHECK(sharp.goes_around(c));
        CHECK(rim.closed());
        CHECK(rim.points().size() == 49);
        CHECK(rim.length() == Approx(96 * std::sin(std::numbers::pi / 48)));
        CHECK(far(rim.at(-0.25), rim.at(rim.length() - 0.25)) < 1e-14);
        CHECK(far(rim.at(0.25), rim.at(2 * rim.length() + 0.25)) < 1e-14);
    }
    CHECK(Feature_curves(prism(circle(48)), 7).corners().size() == 96);  // a side turns by 7.5 degrees
}

TEST_CASE("where a sharp edge turns there is a corner", "[motion][features]") {
    // A low roof: its rim is sharp, its ridges are not.
    Triangle_surface s;
    s.points = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 0.1}};
    s.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const Feature_curves sharp(s, 60);
    CHECK(sharp.corners().size() == 4);
    CHECK(sharp.curves().size() == 4);
    const Feature_curves around(s, 100);  // it turns by 90 degrees
    CHECK(around.corners().empty());
    REQUIRE(around.curves().size() == 1);
    CHECK(around.goes_around(0));
    CHECK(around.curves()[0].length() == Approx(8));
}

TEST_CASE("a curve may end at the corner where it begins", "[motion][features]") {
    std::vector<Coordinates<2>> drop;
    for (const auto& p : circle(60))
        if (p[0] > -0.7) drop.push_back(p);
    std::rotate(drop.begin(),
                std::find_if(drop.begin(), drop.end(), [](const auto& p) { return p[0] < 0 && p[1] < 0; }), drop.end());
    drop.insert(drop.begin(), {-1.5, 0});
    const Feature_curves sharp(prism(drop), 60);
    CHECK(sharp.corners().size() == 2);
    REQUIRE(sharp.curves().size() == 3);
    std::size_t back = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        CHECK_FALSE(sharp.goes_around(c));
        back += sharp.curves()[c].closed();
    }
    CHECK(back == 2);
    // Two vertices on a rim: one just after the corner, one just before it. They are not neighbours across the corner.
    auto features = std::make_shared<const Feature_curves>(sharp);
    const auto rim = static_cast<std::size_t>(
        std::find_if(sharp.curves().begin(), sharp.curves().end(), [](const auto& c) { return c.closed(); }) -
        sharp.curves().begin());
    const double l = sharp.curves()[rim].length();
    const Points points{sharp.curves()[rim].at(0.1 * l), sharp.curves()[rim].at(0.8 * l)};
    const auto wishes = Curve_motion(features, features->places(points, 1e-9)).wishes(points);
    REQUIRE(wishes.size() == 2);
    CHECK(wishes[0].wanted == Approx(0.4 * l));
    CHECK(wishes[1].wanted == Approx(0.55 * l));
}

TEST_CASE("the nearest point of a polyline is that of a look at every segment", "[motion][features]") {
    std::mt19937_64 bits(7);
    const auto number = [&] { return static_cast<double>(bits() >> 11) * 0x1p-53; };
    for (const std::size_t n : {2U, 3U, 33U, 34U, 200U}) {
        Points points{{0, 0, 0}};
        while (points.size() < n) {
            const auto& p = points.back();
            points.push_back({p[0] + number() - 0.4, p[1] + number() - 0.5, p[2] + number() - 0.5});
        }
        const Polyline_3 line(points);
        for (int i = 0; i < 200; ++i) {
            const Coordinates<3> p{20 * number() - 5, 10 * number() - 5, 10 * number() - 5};
            long double least = 1e300L;
            for (std::size_t k = 0; k + 1 < n; ++k) {
                long double dd = 0, de = 0, off = 0;
                for (std::size_t j = 0; j < 3; ++j) {
                    const long double d = static_cast<long double>(points[k + 1][j]) - points[k][j];
                    dd += d * d;
                    de += d * (static_cast<long double>(p[j]) - points[k][j]);
                }
                const long double t = std::clamp(de / dd, 0.0L, 1.0L);
                for (std::size_t j = 0; j < 3; ++j) {
                    const long double x =
                        points[k][j] + t * (static_cast<long double>(points[k + 1][j]) - points[k][j]) - p[j];
                    off += x * x;
                }
                least = std::min(least, std::sqrt(off));
            }
            CHECK(far(p, line.at(line.nearest(p))) == Approx(static_cast<double>(least)).epsilon(1e-12));
        }
        CHECK(line.at(-1) == points.front());
        CHECK(line.at(line.length() + 1) == points.back());
        for (const double t : {0.0, 0.3, 0.99})
            CHECK(line.nearest(line.at(t * line.length())) == Approx(t * line.length()).margin(1e-12));
    }
}

TEST_CASE("places are those of points, whatever their order", "[motion][features]") {
    const Feature_curves sharp(box({1, 0.8, 0.6}), 30);
    Points points{{1, 0.8, 0.6}, {0.2, 0.8, 0.6}, {1, 0.8, -0.6},          {1, 0, -0.6},
                  {0, 0, 0.6},   {0, 0, 0},       {0.2, 0.8, 0.6 + 1e-12}, {0.2, 0.8, 0.601}};
    std::vector<Place> place = sharp.places(points, 1e-9);
    CHECK(place[0] == Place::corner);
    CHECK(static_cast<Index>(place[1]) >= 0);
    CHECK(place[2] == Place::corner);
    CHECK(static_cast<Index>(place[3]) >= 0);
    CHECK(place[3] != place[1]);
    CHECK(place[6] == place[1]);
    for (const std::size_t i : {4U, 5U, 7U}) CHECK(place[i] == Place::off);
    std::reverse(points.begin(), points.end());
    std::reverse(place.begin(), place.end());
    CHECK(sharp.places(points, 1e-9) == place);
    const Coordinates<3> settled = points[1];  // 1e-12 off
    sharp.snap(points, 1e-9);
    CHECK(settled[2] != 0.6);
    CHECK(points[1][0] == Approx(0.2));
    CHECK(points[1][1] == 0.8);
    CHECK(points[1][2] == 0.6);
}

TEST_CASE("vertices on a curve spread evenly between its corners, on the curve to the bit where it lies along an axis",
          "[motion][features]") {
    auto sharp = std::make_shared<const Feature_curves>(box({1, 0.8, 0.6}), 30);
    Points points;
    for (const double x : {-0.99, -0.97, 0.1, 0.11, 0.12, 0.97}) points.push_back({x, -0.8, 0.6});
    const Curve_motion motion(sharp, sharp->places(points, 1e-9));
    for (int i = 0; i < 400; ++i) {
        Points next = points;
        for (const auto& w : motion.wishes(points)) next[static_cast<std::size_t>(w.vertex)] = motion.place(w, 0.75, 1);
        points = next;
        for (std::size_t v = 1; v < points.size(); ++v) REQUIRE(points[v - 1][0] < points[v][0]);
    }
    for (std::size_t v = 0; v < points.size(); ++v) {
        CHECK(points[v][0] == Approx(-1 + 2 * static_cast<double>(v + 1) / 7));
        CHECK(points[v][1] == -0.8);
        CHECK(points[v][2] == 0.6);
        CHECK(motion.holds(v));
        CHECK_FALSE(motion.is_corner(v));
    }
    CHECK_FALSE(Curve_motion().holds(0));
    CHECK(Curve_motion().wishes(points).empty());
}

TEST_CASE("vertices on a curve that goes around spread evenly around it", "[motion][features]") {
    auto sharp = std::make_shared<const Feature_curves>(prism(circle(48)), 30);
    const Polyline_3& rim = sharp->curves()[0];
    Points points;
    for (const double t : {0.9, 0.95, 0.1, 0.15}) points.push_back(rim.at(t * rim.length()));
    const Curve_motion motion(sharp, sharp->places(points, 1e-9));
    for (int i = 0; i < 400; ++i)
        for (const auto& w : motion.wishes(points))
            points[static_cast<std::size_t>(w.vertex)] = motion.place(w, 0.75, 0.1);
    std::vector<double> at;
    for (const auto& p : points) at.push_back(rim.nearest(p));
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0; i < 4; ++i)
        CHECK((i < 3 ? at[i + 1] : at[0] + rim.length()) - at[i] == Approx(rim.length() / 4).epsilon(1e-6));
}
