// SPDX-License-Identifier: GPL-3.0-or-later
// Steady motions that change suddenly: whatever a strategy has derived from them, it never leaves a wrong
// triangulation, in 2D and in 3D.

#include <annulus/arithmetic/limits.h>

#include <common/operation.h>

#include <support/cases.h>
#include <support/repeats.h>
#include <support/viewed_mesh.h>

#include <cmath>
#include <set>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

template <int d>
void holds(const Program_of<d>& program, Coverage* coverage = nullptr) {
    const std::string fault = run_and_shrink(program, 0, coverage);
    INFO(fault);
    REQUIRE(fault.empty());
}

/// side^d points.
template <int d>
Points_of<d> lattice(int side) {
    Points_of<d> points{Coordinates<d>{}};
    for (std::size_t k = 0; k < d; ++k) {
        Points_of<d> more;
        for (const auto& p : points)
            for (int i = 0; i < side; ++i) {
                more.push_back(p);
                more.back()[k] = i;
            }
        points = more;
    }
    return points;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Steady motion that breaks off never leaves a wrong triangulation, dimension", "[motions]",
                       ((int d), d), 2, 3) {
    // All vertices move steadily; then some turn, stop, or return to their first positions, and the motion continues.
    using Do = Calls<d>;
    constexpr std::array steady{Motion::drift, Motion::own_ways, Motion::orbits,
                                Motion::shear, Motion::rotation, Motion::breathing};
    for (const Setting& setting : tolerance_settings()) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 40 : 12, [&](Random& random) {
                const Points_of<d> home = some_points<d>(ordinary_set<d>(random), 4, d == 2 ? 40 : 20, random);
                Program_of<d> program{setting, home, {}};
                const double pace = std::ldexp(1.0, -integer(random, 4, 24));
                const Motion motion = steady[random() % steady.size()];
                for (int leg = 0; leg < 6; ++leg) {
                    program.operations.push_back(
                        Do::steady(motion, integer(random, 3, d == 2 ? 30 : 15), pace, random() % 100));
                    const auto v = static_cast<Index>(random() % home.size());
                    switch (random() % 5) {
                        case 0: program.operations.push_back(Do::move_some(v, home[random() % home.size()])); break;
                        case 1: program.operations.push_back(Do::move_most(home)); break;
                        case 2: program.operations.push_back(Do::stay()); break;
                        case 3: program.operations.push_back(Do::steady(Motion::few, 4, pace, random() % 100)); break;
                        default: break;
                    }
                }
                holds(program);
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Tolerances given up and taken up again never leave a wrong triangulation, dimension",
                       "[motions]", ((int d), d), 2, 3) {
    // In turn: at rest, far within tolerances, about as far as they allow, far beyond them.
    using Do = Calls<d>;
    for (const Setting& setting : tolerance_settings()) {
        DYNAMIC_SECTION(name_of(setting)) {
            for_each_seed(d == 2 ? 40 : 12, [&](Random& random) {
                const Points_of<d> home = some_points<d>(ordinary_set<d>(random), 4, d == 2 ? 40 : 20, random);
                Program_of<d> program{setting, home, {}};
                for (int phase = 0; phase < 5; ++phase) {
                    const int steps = integer(random, 8, d == 2 ? 30 : 24);
                    if (random() % 3 == 0)
                        program.operations.push_back(Do::steady(Motion::tolerances, steps,
                                                                std::array{0.3, 0.999, 1.01, 40.0}[random() % 4],
                                                                random() % 100));
                    else
                        program.operations.push_back(Do::steady(Motion::jitter, steps,
                                                                std::array{0.0, 0x1p-30, 0x1p-12, 0.25}[random() % 4],
                                                                random() % 100));
                }
                holds(program);
            });
        }
    }
}

TEMPLATE_TEST_CASE_SIG("Lattices that wander and return many times are still Delaunay, dimension", "[motions]",
                       ((int d), d), 2, 3) {
    using Do = Calls<d>;
    std::vector<Points_of<d>> homes{lattice<d>(d == 2 ? 7 : 3)};
    if constexpr (d == 3) {
        homes.emplace_back();
        for (int floor = 0; floor < 5; ++floor)  // a prism
            for (int k = 0; k < 4; ++k)
                homes.back().push_back({k % 2 == 0 ? 3.0 : -3.0, k / 2 == 0 ? 4.0 : -4.0, static_cast<double>(floor)});
        Random random(3);
        homes.push_back(point_set(Set_3::sphere, 24, random));
    }
    for (const Setting& setting : certified_settings) {
        CAPTURE(name_of(setting));
        for (const Points_of<d>& home : homes) {
            Program_of<d> program{setting, home, {}};
            const int paces = repeats(d == 2 ? 13 : 4);
            for (int i = 0, k = 1; i < paces; ++i, k += 50 / paces)
                program.operations.push_back(Do::steady(Motion::there_and_back, d == 2 ? 16 : 6, std::ldexp(0.1, -k),
                                                        static_cast<std::uint64_t>(k)));
            program.operations.push_back(Do::recompute_tolerances());
            holds(program);
        }
    }
}

TEMPLATE_TEST_CASE_SIG("After a refused call the flips that it took back do no harm, dimension", "[motions]",
                       ((int d), d), 2, 3) {
    using Do = Calls<d>;
    for (const Setting& setting : tolerance_settings()) {
        CAPTURE(name_of(setting));
        for_each_seed(20, [&](Random& random) {
            const Points_of<d> home = some_points<d>(all_sets<d>()[random() % 5], 12, 12, random);
            Program_of<d> program{setting, home, {}};
            for (int call = 0; call < 6; ++call) {
                const auto v = static_cast<Index>(random() % 1000);
                program.operations.push_back(Do::refused(Refusal::move_meets, v));
                Points_of<d> x = home;
                for (double& c : x[random() % 12]) c *= 0.125 * integer(random, 1, 7);
                program.operations.push_back(Do::move_most(x));
                program.operations.push_back(Do::refused(Refusal::move_all_meets, v));
                program.operations.push_back(Do::move_all(home));
            }
            holds(program);
        });
    }
}

TEMPLATE_TEST_CASE_SIG(
    "The filter gives tolerances up while the motion is fast and takes them up when it is slow, dimension", "[motions]",
    ((int d), d), 2, 3) {
    Random random(7);
    Points_of<d> x(d == 2 ? 500 : 200);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1.0, 1.0);
    Viewed_mesh<d> dt(std::span<const Coordinates<d>>(x), {.strategy = Strategy::tolerances});
    const auto step = [&](double pace) {
        for (auto& p : x)
            for (double& c : p) c += pace * between(random, -1.0, 1.0);
        const Move_result report = dt.move_all(std::span<const Coordinates<d>>(x));
        REQUIRE(dt.audit().delaunay());
        return report;
    };
    for (int i = 0; i < 20; ++i) {
        const Move_result report = step(0.1);
        CHECK(report.statistics.sign_steps == 1);
        CHECK(report.moves.within_tolerance < 5);
    }
    for (int i = 0; i < 20; ++i) (void)step(1e-9);
    const Move_result slow = step(1e-9);
    if (!Limits::tiny) {  // expiries of few bits lose the rest of a tolerance
        CHECK(slow.statistics.evaluated < x.size() / 10);
        CHECK(slow.moves.within_tolerance > x.size() * 9 / 10);
    }
    for (int i = 0; i < 3; ++i) (void)step(0.1);
    CHECK(step(0.1).statistics.sign_steps == 1);
}

TEMPLATE_TEST_CASE_SIG("paper-hybrid becomes paper once the motion is slow, and then is one, dimension", "[motions]",
                       ((int d), d), 2, 3) {
    using Do = Calls<d>;
    for_each_seed(10, [&](Random& random) {
        const Points_of<d> home = some_points<d>(ordinary_set<d>(random), 10, 20, random);
        Coverage coverage;
        holds<d>({Strategy::paper_hybrid,
                  home,
                  {Do::steady(Motion::jitter, 5, 0.5, random() % 100), Do::steady(Motion::rest_and_go, 12, 0x1p-40, 0),
                   Do::steady(Motion::tolerances, 12, 0.9, random() % 100), Do::steady(Motion::jitter, 8, 0.3, 5)}},
                 &coverage);
        CHECK(coverage.switches == 1);
        CHECK(coverage.report.moves.within_tolerance > 0);
    });
}
