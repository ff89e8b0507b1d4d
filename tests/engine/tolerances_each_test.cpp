// SPDX-License-Identifier: GPL-3.0-or-later
// tolerances-each drops tolerances while they do not pay, and computes them again later; the triangulation is always
// Delaunay.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/repeats.h>

#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <algorithm>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <class Moving>
std::vector<Coordinates<Moving::d>> points_of(std::size_t n, Random& random) {
    std::vector<Coordinates<Moving::d>> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1, 1);
    return x;
}

/// A time step in which every vertex moves by at most `way` in a random direction.
template <class Moving>
Move_report shake(Moving& dt, double way, Random& random) {
    std::vector<Coordinates<Moving::d>> x(dt.positions().begin(), dt.positions().end());
    for (auto& p : x)
        for (double& c : p) c += between(random, -way, way);
    return dt.move_all(std::span<const Coordinates<Moving::d>>(x));
}

}  // namespace

TEMPLATE_TEST_CASE("tolerances-each keeps tolerances while they pay", "[relocation]", Moving_delaunay_2,
                   Moving_delaunay_3) {
    constexpr int d = TestType::d;
    Random random(1);
    Options options;
    options.strategy = Strategy::tolerances_each;
    TestType dt(points_of<TestType>(300, random), options);
    const auto n = static_cast<std::uint64_t>(dt.number_of_vertices());
    const auto check = [&dt] {
        const Audit_result audit = dt.audit();
        INFO(audit.first_fault);
        REQUIRE(audit.delaunay());
    };
    for (int round = 2 - repeats(2); round < 2; ++round) {
        // Fast: after a few time steps no vertex passes the step test any more, because there are no tolerances.
        Move_report report;
        for (int step = 0; step < 25; ++step) {
            report = shake(dt, 0.1, random);
            CHECK(report.moves.asked == n);
            check();
        }
        CHECK(report.moves.within_tolerance == 0);
        CHECK(report.star_walks == 0);
        // A resting vertex still passes.
        report = shake(dt, 0.0, random);
        CHECK(report.moves.within_tolerance == n);
        // Calls of other kinds meanwhile.
        if (round == 1) {
            Coordinates<d> p{};
            p[0] = 0.015625;
            Move_report one;
            const auto v = dt.vertex(7);
            one = dt.move(7, p);
            CHECK(one.moves.asked == 1);
            check();
            CHECK(dt.tolerance(v) >= 0);
            for (int step = 0; step < 25; ++step) (void)shake(dt, 0.1, random);
            const auto w =
                dt.insert(typename TestType::Point(dt.position(v)) + (dt.position(dt.vertex(1)) - dt.position(v)) / 3);
            check();
            dt.remove(w);
            check();
        }
        // Slow: tolerances are computed again.
        for (int step = 0; step < 25; ++step) {
            report = shake(dt, 1e-9, random);
            check();
        }
        CHECK(report.moves.within_tolerance > n / 2);
        CHECK(report.evaluated < n);
    }
}

TEMPLATE_TEST_CASE("a time step of tolerances-each that fails leaves everything where it was", "[relocation]",
                   Moving_delaunay_2, Moving_delaunay_3) {
    constexpr int d = TestType::d;
    Random random(1);
    Options options;
    options.strategy = Strategy::tolerances_each;
    for (const double way : {0.1, 1e-9}) {  // without tolerances and with
        TestType dt(points_of<TestType>(100, random), options);
        for (int step = 0; step < 20; ++step) (void)shake(dt, way, random);
        const std::vector<Coordinates<d>> before(dt.positions().begin(), dt.positions().end());
        std::vector<Coordinates<d>> x = before;
        for (auto& p : x) p[0] += 0.25;
        x[5] = x[80];
        CHECK_THROWS_AS(dt.move_all(std::span<const Coordinates<d>>(x)), Error);
        CHECK(std::equal(before.begin(), before.end(), dt.positions().begin()));
        CHECK(dt.audit().delaunay());
        x[5][0] += 0.5;
        (void)dt.move_all(std::span<const Coordinates<d>>(x));
        CHECK(std::equal(x.begin(), x.end(), dt.positions().begin()));
        CHECK(dt.audit().delaunay());
    }
}
