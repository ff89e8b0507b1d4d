// SPDX-License-Identifier: GPL-3.0-or-later
// tolerances-each drops tolerances while they do not pay, and computes them again later; the triangulation is always
// Delaunay.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/repeats.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <vector>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

template <class Moving>
std::vector<Coordinates<Moving::dimension_of_space>> points_of(std::size_t n, Random& random) {
    std::vector<Coordinates<Moving::dimension_of_space>> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1, 1);
    return x;
}

/// A time step in which every vertex moves by at most `way` in a random direction.
template <class Moving>
Move_result shake(Moving& dt, double way, Random& random) {
    std::vector<Coordinates<Moving::dimension_of_space>> x(dt.points().begin(), dt.points().end());
    for (auto& p : x)
        for (double& c : p) c += between(random, -way, way);
    return dt.move_all(std::span<const Coordinates<Moving::dimension_of_space>>(x));
}

}  // namespace

TEMPLATE_TEST_CASE("tolerances-each keeps tolerances while they pay", "[relocation]", Viewed_mesh_2, Viewed_mesh_3) {
    constexpr int d = TestType::dimension_of_space;
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
        Move_result report;
        for (int step = 0; step < 25; ++step) {
            report = shake(dt, 0.1, random);
            CHECK(report.moves.asked == n);
            check();
        }
        CHECK(report.moves.within_tolerance == 0);
        CHECK(report.statistics.star_walks == 0);
        // A resting vertex still passes.
        report = shake(dt, 0.0, random);
        CHECK(report.moves.within_tolerance == n);
        // Calls of other kinds meanwhile.
        if (round == 1) {
            Coordinates<d> p{};
            p[0] = 0.015625;
            Move_result one;
            one = dt.move(7, p);
            CHECK(one.moves.asked == 1);
            check();
            CHECK(dt.tolerance(7) >= 0);
            for (int step = 0; step < 25; ++step) (void)shake(dt, 0.1, random);
            p = dt.points()[7];
            for (std::size_t k = 0; k < d; ++k) p[k] += (dt.points()[1][k] - p[k]) / 3;
            const Index w = dt.insert(p);
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
        CHECK(report.statistics.evaluated < n);
    }
}

TEMPLATE_TEST_CASE("a time step of tolerances-each that fails leaves everything where it was", "[relocation]",
                   Viewed_mesh_2, Viewed_mesh_3) {
    constexpr int d = TestType::dimension_of_space;
    Random random(1);
    Options options;
    options.strategy = Strategy::tolerances_each;
    for (const double way : {0.1, 1e-9}) {  // without tolerances and with
        TestType dt(points_of<TestType>(100, random), options);
        for (int step = 0; step < 20; ++step) (void)shake(dt, way, random);
        const std::vector<Coordinates<d>> before(dt.points().begin(), dt.points().end());
        std::vector<Coordinates<d>> x = before;
        for (auto& p : x) p[0] += 0.25;
        x[5] = x[80];
        CHECK_THROWS_AS(dt.move_all(std::span<const Coordinates<d>>(x)), Error);
        CHECK(std::equal(before.begin(), before.end(), dt.points().begin()));
        CHECK(dt.audit().delaunay());
        x[5][0] += 0.5;
        (void)dt.move_all(std::span<const Coordinates<d>>(x));
        CHECK(std::equal(x.begin(), x.end(), dt.points().begin()));
        CHECK(dt.audit().delaunay());
    }
}
