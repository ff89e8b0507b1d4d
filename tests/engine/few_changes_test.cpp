// SPDX-License-Identifier: GPL-3.0-or-later
// Insertions and removals list changed cells from the places written to, without reading all cells: counted in bytes
// allocated.
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/viewed_mesh.h>

#include <random>
#include <vector>

using namespace annulus;
using annulus::testing::Failing_new;

namespace {

template <int d>
Coordinates<d> anywhere(std::mt19937_64& random) {
    Coordinates<d> p;
    for (double& c : p) c = std::uniform_real_distribution<double>()(random);
    return p;
}

template <int d>
using Delaunay_of = testing::Viewed_mesh<d>;

template <int d, class Triangulation>
void check_few(Strategy strategy) {
    std::mt19937_64 random(7);
    CAPTURE(name_of(strategy));
    std::vector<Coordinates<d>> points(6000);
    for (auto& p : points) p = anywhere<d>(random);
    Options options;
    options.strategy = strategy;
    options.report_changes = true;
    Triangulation dt(std::span<const Coordinates<d>>(points), options);
    // All cells, listed once; the first call allocates room for them in the change log and elsewhere.
    const std::uint64_t all = dt.cells().vertices.size() * (d + 1) * sizeof(Index);
    for (int round = 0; round < 2; ++round) {
        for (int k = 0; k < 8; ++k) {
            Move_result came, went;
            const Failing_new counting(std::uint64_t{1} << 60);
            (void)dt.insert(anywhere<d>(random), &came);
            dt.remove(k, &went);
            CHECK_FALSE(came.changed.empty());
            CHECK_FALSE(went.gone.empty());
            if (k > 0) CHECK(Failing_new::bytes() < all / 2);
        }
        if (strategy == Strategy::relocate) break;  // which is slow
        std::vector<Coordinates<d>> x(dt.points().begin(), dt.points().end());
        for (auto& p : x) p[0] *= 1 + 1e-9;
        (void)dt.move_all(std::span<const Coordinates<d>>(x));
        REQUIRE(dt.audit().delaunay());
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("What few vertices change is listed at their cost, dimension", "[engine]", ((int d), d), 2, 3) {
    for (const Strategy strategy : {Strategy::automatic, Strategy::rebuild, Strategy::relocate, Strategy::tolerances}) {
        check_few<d, Moving_mesh<d>>(strategy);
        check_few<d, Delaunay_of<d>>(strategy);
    }
}

TEMPLATE_TEST_CASE_SIG("A list of changes does not change the time steps, dimension", "[engine]", ((int d), d), 2, 3) {
    for (const Strategy strategy :
         {Strategy::automatic, Strategy::rebuild, Strategy::relocate, Strategy::paper_hybrid}) {
        CAPTURE(name_of(strategy));
        std::mt19937_64 random(8);
        std::vector<Coordinates<d>> x(300);
        for (auto& p : x) p = anywhere<d>(random);
        Options quiet, telling;
        quiet.strategy = telling.strategy = strategy;
        telling.report_changes = true;
        Delaunay_of<d> one(std::span<const Coordinates<d>>(x), quiet),
            other(std::span<const Coordinates<d>>(x), telling);
        for (int round = 0; round < 3; ++round) {
            const Coordinates<d> p = anywhere<d>(random);
            for (auto* dt : {&one, &other}) {
                Move_result unused;
                (void)dt->insert(p, &unused);
                dt->remove(3 + round, &unused);
            }
            x.push_back(p);
            for (auto& q : x)
                for (double& c : q) c += std::uniform_real_distribution<double>(0, 0.1)(random);
            x.resize(one.index_bound());
            const Move_result a = one.move_all(std::span<const Coordinates<d>>(x)),
                              b = other.move_all(std::span<const Coordinates<d>>(x));
            CHECK(a.moves == b.moves);
            CHECK(a.statistics.rebuild_steps == b.statistics.rebuild_steps);
            CHECK(a.statistics.cost == b.statistics.cost);
            CHECK_FALSE(b.changed.empty());
            REQUIRE(other.audit().delaunay());
        }
    }
}
