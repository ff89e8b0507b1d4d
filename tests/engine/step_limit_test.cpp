// SPDX-License-Identifier: GPL-3.0-or-later
// The most expensive time step of `auto`, in rebuilds, by counted costs: recomputation of tolerances in slices, and
// repairs that do not fail late. No clock is read.
#include <annulus/arithmetic/limits.h>
#include <annulus/engine/late_rounds.h>
#include <annulus/engine/rebuild_policy.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include "../../bench/motions/families.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

using namespace annulus;

namespace {

template <int d>
struct Run {
    bench::Scene<d> scene;
    Moving_mesh<d> mesh;

    Run(std::string_view family, std::string_view motion, std::size_t n, double spacings, std::uint64_t seed,
        const Options& options = {})
        : scene(family, motion, n, spacings, seed), mesh(std::span<const Coordinates<d>>(scene.points()), options) {}
    Move_result step() {
        scene.step();
        std::vector<Coordinates<d>> x(scene.points().begin(), scene.points().end());
        x.resize(mesh.points().size());  // a vertex was inserted and removed
        return mesh.move_all(std::span<const Coordinates<d>>(x));
    }
    [[nodiscard]] double rebuilds(const Move_result& r) const {
        return r.statistics.cost / Rebuild_policy<d>::rebuild_cost(mesh.number_of_vertices());
    }
};

}  // namespace

// Where repair would be given up late, or all tolerances be computed at once. Of uniform points, where facets are stuck
// at which each round would cost as much as the first.
TEMPLATE_TEST_CASE_SIG("No step of auto costs more than one and a half rebuilds of its own, dimension", "[repair]",
                       ((int d), d), 2, 3) {
    constexpr std::size_t n = d == 2 ? 5000 : 3000;
    constexpr int steps = Limits::tiny ? 8 : 40;  // with sanitizers a step takes twenty times as long
    struct Case {
        std::string_view family, motion;
        double spacings;
        double most = 1.5;
        std::uint64_t seeds = 1;
        double mean = 1.5;
    };
    // clang-format off
    const std::vector<Case> in_2d{
        {"slab", "walk", 0.05}, {"slab", "walk", 0.07}, {"clusters", "walk", 0.2}, {"clusters", "walk", 0.001},
        {"uniform", "few", 0.01}, {"ball", "burst", 0.01}, {"lattice", "shear", 0.003},
        {"lattice", "shear", 0.05, 1.5, 8}, {"faces", "shear", 0.05}, {"slab", "burst", 0.008},
        {"lattice", "shear", 0.2, 1.5, 3, 0.65}};
    const std::vector<Case> in_3d{
        {"slab", "walk", 0.003}, {"slab", "walk", 0.01, 1.2, 4}, {"slab", "burst", 0.001},
        {"uniform", "walk", 0.03, 1.05}, {"ball", "walk", 0.03}, {"clusters", "walk", 0.003},
        {"clusters", "walk", 0.01}, {"clusters", "walk", 0.02}, {"clusters", "walk", 0.03},
        {"ball", "few", 0.01}, {"ball", "burst", 0.001}, {"faces", "burst", 0.02, 1.24, 2},
        {"faces", "few", 0.003}};
    // clang-format on
    const std::vector<Case>& cases = d == 2 ? in_2d : in_3d;
    for (const auto& [family, motion, spacings, limit, seeds, mean] : cases) {
        double all = 0.0;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            CAPTURE(family, motion, spacings, seed);
            Run<d> run(family, motion, n, spacings, seed);
            double most = 0.0;
            for (int step = 0; step < steps; ++step) {
                const double cost = run.rebuilds(run.step());
                most = std::max(most, cost);
                all += cost;
            }
            CHECK(most <= limit);
            REQUIRE(run.mesh.audit().delaunay());
        }
        CAPTURE(family, motion, spacings);
        if (!Limits::tiny) CHECK(all <= mean * static_cast<double>(steps) * static_cast<double>(seeds));
    }
}

// Few points move: tolerances pay. They are there after some time steps, and stand up to the audit from the first on.
TEMPLATE_TEST_CASE_SIG("Tolerances are recomputed in slices, and the steps meanwhile are certified, dimension",
                       "[engine]", ((int d), d), 2, 3) {
    constexpr std::size_t n = d == 2 ? 2000 : 1000;
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        for (const int threads : {1, 3}) {
            if (threads > 1 && seed > 1) continue;
            CAPTURE(seed, threads);
            Options options;
            options.threads = threads;
            Run<d> run("uniform", "few", n, d == 2 ? 0.05 : 0.01, seed, options);
            int slices = 0;
            std::uint64_t recomputed = 0, within = 0;
            for (int step = 0; step < 30; ++step) {
                CAPTURE(step);
                const Move_result r = run.step();
                if (recomputed == 0 && run.rebuilds(r) > 1.1) ++slices;
                if (recomputed > 0) within += r.moves.within_tolerance;
                recomputed += r.statistics.tolerance_recomputations;
                CHECK(run.rebuilds(r) <= 1.5);
                if (r.statistics.tolerance_recomputations > 0)
                    for (Index v = 0; static_cast<std::size_t>(v) < n; ++v)
                        REQUIRE((run.mesh.displacement(v) == 0.0 || run.mesh.displacement(v) < run.mesh.tolerance(v)));
                REQUIRE(run.mesh.audit().delaunay());
                if (recomputed > 0 || step % 3 != 2) continue;
                // Whatever else is done before the last slice.
                if (seed % 3 == 1) {
                    const Index v = run.mesh.insert(Coordinates<d>{});
                    REQUIRE(run.mesh.audit().delaunay());
                    run.mesh.remove(v);
                } else if (seed % 3 == 2) {
                    Coordinates<d> p = run.mesh.points()[0];
                    p[0] += 1e-3;
                    recomputed += run.mesh.move(0, p).statistics.tolerance_recomputations;  // of all, at once
                }
                REQUIRE(run.mesh.audit().delaunay());
            }
            CHECK(recomputed >= 1);
            CHECK(within > 0);
            if (seed % 3 == 0) CHECK(slices >= 1);
        }
}

// The table grows beyond what it was at the first slice, and the star of a vertex that left its tolerance has cells
// whose expiries were read beyond the end of an array. The library's assertions find that (preset `sanitize-all`).
TEST_CASE("Steps that make cells while tolerances are computed in slices", "[engine]") {
    constexpr std::size_t n = 500;
    int grown = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        Run<3> run("uniform", "few", n, 0.01, seed);
        bench::Scene<3> all("uniform", "walk", n, 0.001, seed);
        const std::vector<Coordinates<3>> from(all.points().begin(), all.points().end());
        Cell_index bound;
        bool begun = false;
        for (int step = 0; step < 30; ++step) {
            CAPTURE(step);
            run.scene.step();
            if (begun) all.step();
            std::vector<Coordinates<3>> x(run.scene.points().begin(), run.scene.points().end());
            for (std::size_t v = 0; v < n; ++v)
                for (std::size_t k = 0; k < 3; ++k) x[v][k] += all.points()[v][k] - from[v][k];
            const Move_result r = run.mesh.move_all(std::span<const Coordinates<3>>(x));
            const Cell_index before = std::exchange(bound, run.mesh.mesh().table().cell_bound());
            const bool ends = r.statistics.tolerance_recomputations > 0;
            if (begun && ends && bound > before) ++grown;
            begun = run.rebuilds(r) > 1.1 && !ends;
            REQUIRE(run.mesh.audit().delaunay());
        }
    }
    CHECK(grown > 0);
}

TEST_CASE("Vertices held back are reinserted when rounds stop paying", "[repair]") {
    constexpr std::size_t n = 1000;
    const double rebuild = Rebuild_policy<3>::rebuild_cost(n);
    Late_rounds<3> rounds(rebuild, 0.1 * rebuild);
    rounds.note(0.4 * rebuild, 0.55 * rebuild);  // the first round: nothing was held back before
    CHECK_FALSE(rounds.reinserts(false));
    CHECK(rounds.reinserts(true));
    rounds.note(0.45 * rebuild, 0.3 * rebuild);  // it paid
    CHECK_FALSE(rounds.reinserts(false));
    rounds.note(0.49 * rebuild, 0.28 * rebuild);  // these do not
    CHECK_FALSE(rounds.reinserts(false));
    rounds.note(0.495 * rebuild, 0.02 * rebuild);
    CHECK_FALSE(rounds.reinserts(false));
    rounds.note(0.52 * rebuild, 0.02 * rebuild);
    CHECK(rounds.reinserts(false));
    rounds.note(0.53 * rebuild, 0.0);
    CHECK_FALSE(rounds.reinserts(true));
    CHECK_FALSE(rounds.gives_up());
    Late_rounds<3> hopeless(rebuild, 0.1 * rebuild);
    hopeless.note(0.4 * rebuild, 1.2 * rebuild);
    CHECK_FALSE(hopeless.reinserts(true));
    CHECK_FALSE(hopeless.gives_up());
    hopeless.note(0.6 * rebuild, 1.18 * rebuild);
    CHECK(hopeless.gives_up());
}
