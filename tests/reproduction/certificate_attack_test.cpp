// SPDX-License-Identifier: GPL-3.0-or-later
// Moves that the paper's algorithm accepts although the triangulation is no longer Delaunay.
#include <annulus/audit.h>
#include <annulus/measure/counterexample.h>
#include <annulus/predicate/filtered.h>
#include <apps/reproduction/certificate_attack.h>

#include <support/catch.h>

#include <cmath>
#include <random>

namespace {

using namespace annulus;
using Point = Coordinates<3>;

/// {a, b, c, p, q} of a bi-cell of the counterexample: the facet is a, b, p; q and r are opposite.
std::vector<Point> five_points(double delta) {
    const double s = 0.5 * std::sqrt(3.0);
    return {{0, 0, 1 - delta}, {0, 0, -(1 - delta)}, {1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}};
}

std::vector<Point> cube(std::size_t n, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> side(0, 1);
    std::vector<Point> x(n);
    for (Point& p : x)
        for (double& c : p) c = side(random);
    return x;
}

double length(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

}  // namespace

TEST_CASE("The counterexample's certificate breaks within the paper's tolerance and not within the exact one") {
    const Counterexample c = counterexample(0.01);
    const std::vector<Point> x = five_points(0.01);
    REQUIRE(empty_sphere_exact({&x[0], &x[1], &x[2], &x[3], &x[4]}).sign > 0);
    const auto moved = break_certificate(x, std::vector<double>(5, c.paper));
    REQUIRE(moved);
    for (std::size_t i = 0; i < 5; ++i) CHECK(length((*moved)[i], x[i]) < c.paper);
    const auto& y = *moved;
    CHECK(empty_sphere_exact({&y[0], &y[1], &y[2], &y[3], &y[4]}).sign < 0);
    // The audit, which shares no code with the certificates: three cells around a b are not Delaunay there.
    Audit_input<3> three{x, {{0, 1, 3, 2}, {0, 1, 4, 3}, {0, 1, 2, 4}}};
    CHECK(audit(three).delaunay());
    three.points = y;
    CHECK_FALSE(audit(three).delaunay());
    CHECK_FALSE(break_certificate(x, std::vector<double>(5, c.exact)));
}

TEST_CASE("A cell breaks across its thinnest slab, and not by less than half its width") {
    const std::vector<Point> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 0.01}};
    REQUIRE(orientation_exact({&flat[0], &flat[1], &flat[2], &flat[3]}).sign > 0);
    CHECK(break_certificate(flat, std::vector<double>(4, 0.00501)));
    CHECK_FALSE(break_certificate(flat, std::vector<double>(4, 0.00499)));
}

TEST_CASE("What the adversary finds is accepted by the paper's algorithm and refuted by the exact audit") {
    const std::vector<Point> x = cube(300, 5);
    Moving_delaunay_3 dt = paper_triangulation<3>(x);
    std::vector<std::vector<Index>> unsound;
    const Degeneracy_count_record counts =
        count_degeneracy<3>(dt, [&](std::span<const Index> v) { unsound.emplace_back(v.begin(), v.end()); });
    REQUIRE(counts.unsound_certificates == unsound.size());
    REQUIRE(unsound.size() > 10);
    const Attack_record r = attack(dt, unsound, 0, 10);
    CHECK(r.certificates == unsound.size());
    CHECK(r.broken == r.certificates);
    CHECK(r.accepted == r.broken);
    CHECK(r.audited == 10);
    CHECK(r.refuted == 10);
    CHECK_FALSE(r.example.empty());
    CHECK(dt.audit().delaunay());  // all moved back
    CHECK(attack(dt, unsound, 4, 0).certificates <= 4);
}

TEST_CASE("Within certified tolerances the adversary finds nothing") {
    const std::vector<Point> x = cube(300, 6);
    Moving_delaunay_3 dt = paper_triangulation<3>(x);
    const Moving_delaunay_3 certified{std::span<const Point>(x)};
    std::vector<std::vector<Index>> unsound;
    (void)count_degeneracy<3>(dt, [&](std::span<const Index> v) { unsound.emplace_back(v.begin(), v.end()); });
    REQUIRE_FALSE(unsound.empty());
    for (const auto& points : unsound) {
        std::vector<Point> p;
        std::vector<double> reach;
        for (const Index v : points) {
            p.push_back(x[static_cast<std::size_t>(v)]);
            reach.push_back(certified.tolerance(certified.vertex(static_cast<std::size_t>(v))));
        }
        CHECK_FALSE(break_certificate(p, reach));
    }
}
