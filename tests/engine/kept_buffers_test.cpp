// SPDX-License-Identifier: GPL-3.0-or-later
// When the buffers of rebuilds are there: while time steps are rebuilt and a few more, by counts alone.
#include <annulus/engine/engine.h>
#include <annulus/engine/update_strategy.h>
#include <annulus/published/strategies.h>

#include <support/catch.h>
#include <support/generators.h>

#include <cmath>
#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// An engine and its mesh, of uniform points.
template <int d>
struct Run {
    static constexpr std::size_t n = 400;

    explicit Run(Strategy strategy) : engine(mesh, options_of(strategy), make_strategy<d>(mesh, options_of(strategy))) {
        for (auto& p : x)
            for (double& c : p) c = unit(random);
        engine.build(x);
    }
    static Options options_of(Strategy strategy) {
        Options options;
        options.strategy = strategy;
        return options;
    }
    /// A time step of so many spacings. Returns whether it was rebuilt.
    bool step(double spacings) {
        const double most = spacings * std::pow(static_cast<double>(n), -1.0 / d);
        for (auto& p : x)
            for (double& c : p) c += between(random, -most, most);
        return engine.move_all(x).moves.rebuilt > 0;
    }

    Random random{7};
    std::vector<Coordinates<d>> x{n};
    Delaunay_mesh<d> mesh;
    Engine<d> engine;
};

constexpr int few = 8;  // time steps

}  // namespace

TEMPLATE_TEST_CASE_SIG("Buffers of rebuilds are freed a few time steps after the last rebuild, dimension", "[engine]",
                       ((int d), d), 2, 3) {
    for (const Strategy strategy : {Strategy::automatic, Strategy::tolerances}) {
        Run<d> run(strategy);
        CHECK(!run.mesh.holds_buffers());  // it may never be rebuilt
        for (int round = 0; round < 2; ++round) {
            CAPTURE(d, name_of(strategy), round);
            for (int k = 0; k < 3; ++k) {
                REQUIRE(run.step(100.0));
                CHECK(run.mesh.holds_buffers());
            }
            int calm = 0;
            for (int k = 0; k < 80 && calm < few; ++k) {
                CHECK(run.mesh.holds_buffers());
                calm = run.step(1e-4) ? 0 : calm + 1;
            }
            CHECK(calm == few);
            CHECK(!run.mesh.holds_buffers());
            CHECK(!run.step(1e-4));
            CHECK(!run.mesh.holds_buffers());
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Steps that are rebuilt, now and then with others between, keep their buffers, dimension",
                       "[engine]", ((int d), d), 2, 3) {
    Run<d> each(Strategy::rebuild);
    for (int k = 0; k < 3 * few; ++k) {
        CHECK(each.step(1e-4));
        CHECK(each.mesh.holds_buffers());
    }
    Run<d> some(Strategy::tolerances);
    for (int k = 0; k < 6 * few; ++k) {
        if (k % few == 0) REQUIRE(some.step(100.0));
        else (void)some.step(1e-4);
        CHECK(some.mesh.holds_buffers());
    }
}

TEMPLATE_TEST_CASE_SIG("Insertions, removals and moves of single vertices do not free buffers, dimension", "[engine]",
                       ((int d), d), 2, 3) {
    Run<d> run(Strategy::rebuild);
    CHECK(run.step(0.01));
    for (int k = 0; k < 3 * few; ++k) {
        Coordinates<d> p;
        for (double& c : p) c = unit(run.random);
        Move_result report;
        const Index v = run.engine.insert(p, report);
        run.engine.remove(v, report);
    }
    CHECK(run.mesh.holds_buffers());
}
