// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's cells are CGAL's: every family of the benchmarks, small sets on and near what is degenerate, scales from
// one end of the domain to the other.
#include <annulus/arithmetic/limits.h>
#include <annulus/kernel/builder.h>
#include <annulus/mesh/certificates.h>

#include <support/built_numbers.h>
#include <support/catch.h>
#include <support/repeats.h>
#include <support/small_sets.h>

#include <common/cgal_cells.h>

#include "../../bench/motions/families.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
void distinct(std::vector<Coordinates<d>>& x) {
    std::set<Coordinates<d>> met;
    std::erase_if(x, [&](const auto& p) { return !met.insert(p).second; });
}

template <int d>
void check(Builder<d>& builder, const std::vector<Coordinates<d>>& x) {
    std::vector<Index> order(x.size());
    std::iota(order.begin(), order.end(), Index{0});
    const bool full = builder.build(x, order);
    const auto [dimension, cells] = oracle::cells_by_cgal<d>({x.begin(), x.end()});
    REQUIRE(full == (dimension == d));
    if (!full) return;
    Corner_table<d> table;
    builder.copy_to(table, x.size());
    REQUIRE(glued(table));
    REQUIRE(oracle::cells_of(table) == cells);
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("The kernel builds the cells that CGAL builds, whatever the family, dimension", "[kernel]",
                       ((int d), d), 2, 3) {
    Builder<d> builder;
    for (const std::string_view family : bench::families)
        for (const std::size_t n : {5U, 30U, 300U, 1500U}) {
            CAPTURE(d, family, n);
            const bench::Scene<d> scene(family, "walk", n, 0.1, n);
            check<d>(builder, {scene.points().begin(), scene.points().end()});
        }
}

TEMPLATE_TEST_CASE_SIG("The kernel builds the cells that CGAL builds of small degenerate sets, dimension", "[kernel]",
                       ((int d), d), 2, 3) {
    Builder<d> builder;
    Random random(run_seed());
    for (int k = 0; k < repeats(400); ++k)
        for (const auto set : all_small_sets) {
            const double off = k % 3 == 0 ? 0.0 : std::ldexp(1.0, -static_cast<int>(random() % 60));
            auto x = small_set<d>(set, 1 + random() % 40, off, random);
            const int scale = k % 4 != 0 ? 0 : static_cast<int>(random() % 1500) - 1000;
            for (auto& p : x)
                for (double& c : p) c = std::ldexp(c, scale);
            distinct<d>(x);
            CAPTURE(d, k, static_cast<int>(set), off, scale);
            check<d>(builder, x);
        }
}

TEMPLATE_TEST_CASE_SIG("The kernel builds coordinates of all magnitudes at once, dimension", "[kernel]", ((int d), d),
                       2, 3) {
    Builder<d> builder;
    Random random(run_seed());
    for (int k = 0; k < repeats(100); ++k) {
        std::vector<Coordinates<d>> x(1 + random() % 30);
        for (auto& p : x)
            for (double& c : p) c = std::ldexp(between(random, -1, 1), static_cast<int>(random() % 1570) - 1070);
        distinct<d>(x);
        CAPTURE(d, k);
        check<d>(builder, x);
    }
}

TEST_CASE("The kernel grows beyond the cells that it made room for, and past borders of few vertices", "[kernel]") {
    Builder<3> builder;
    std::vector<Coordinates<3>> x;  // on a moment curve all of them are neighbours of one another
    for (int i = 1; i <= 200; ++i) {
        const double t = i / 64.0;
        x.push_back({t, t * t, t * t * t});
    }
    check<3>(builder, x);
    check<3>(builder, {x.begin(), x.begin() + 20});
}

TEMPLATE_TEST_CASE_SIG("The kernel names two points at one place, dimension", "[kernel]", ((int d), d), 2, 3) {
    Builder<d> builder;
    const bench::Scene<d> scene("uniform", "walk", 200, 0.1, 1);
    std::vector<Coordinates<d>> x(scene.points().begin(), scene.points().end());
    const std::vector<Coordinates<d>> good = x;
    x[120] = x[17];
    std::vector<Index> order(x.size());
    std::iota(order.begin(), order.end(), Index{0});
    try {
        (void)builder.build(x, order);
        FAIL("two points at one place");
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::duplicate_point);
        CHECK(std::vector(e.vertices().begin(), e.vertices().end()) == std::vector<std::int64_t>{17, 120});
    }
    check<d>(builder, good);  // its buffers are intact
}

TEMPLATE_TEST_CASE_SIG("The kernel's cells have the same numbers with any number of threads, dimension", "[kernel]",
                       ((int d), d), 2, 3) {
    // Rounds of several threads, in 3D with a second pass.
    constexpr std::size_t many = Limits::tiny ? 3000 : d == 2 ? 20000 : 60000;
    Builder<d> builder;
    for (const std::string_view family : {"uniform", "clusters", "faces"}) {
        CAPTURE(d, family);
        const bench::Scene<d> scene(family, "walk", many, 0.1, 1);
        const auto alone = built_numbers<d>(builder, scene.points(), 1);
        for (const int threads : {2, 5}) CHECK((built_numbers<d>(builder, scene.points(), threads) == alone));
    }
    const bench::Scene<d> scene("uniform", "walk", many, 0.1, 1);
    std::vector<Coordinates<d>> x(scene.points().begin(), scene.points().end());
    x[many / 2] = x[17] = x[many - many / 8];
    std::vector<Index> all(many);
    std::iota(all.begin(), all.end(), Index{0});
    const auto named = [&](int threads) {
        try {
            (void)builder.build(x, all, threads);
        } catch (const Error& e) {
            return std::vector(e.vertices().begin(), e.vertices().end());
        }
        return std::vector<std::int64_t>();
    };
    CHECK(named(1).size() == 2);
    CHECK(named(3) == named(1));
}
