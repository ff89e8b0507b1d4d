// SPDX-License-Identifier: GPL-3.0-or-later
// Large steps: walks of up to a spacing in every family of points, near-degenerate and with moving hulls; the cost of
// repair, and where it arises.
#include <annulus/engine/rebuild_policy.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_mesh.h>

#include <support/cases.h>
#include <support/catch.h>
#include <support/viewed_mesh.h>
#include "../../bench/motions/families.h"

#include <map>

using namespace annulus;
using namespace annulus::oracle;
using namespace annulus::testing;

namespace {

template <int d>
using Moving_of = Viewed_mesh<d>;

template <int d>
Moving_of<d> moving(const Points_of<d>& x, Strategy strategy) {
    Options options;
    options.strategy = strategy;
    return Moving_of<d>(std::span<const Coordinates<d>>(x), options);
}

/// Delaunay, and the cells of a rebuild where they are unique.
template <int d>
void check_cells(const Moving_of<d>& dt) {
    const Audit_result audit = dt.audit();
    REQUIRE(audit.first_fault == "");
    REQUIRE(audit.delaunay());
    if (audit.degenerate_facets > 0) return;
    const Points_of<d> x(dt.points().begin(), dt.points().end());
    const Moving_of<d> rebuilt = moving<d>(x, Strategy::rebuild);
    REQUIRE(cells_of(dt) == cells_of(rebuilt));
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A walk of any reach in any family of points leaves the Delaunay triangulation, dimension",
                       "[repair]", ((int d), d), 2, 3) {
    // By size of steps: the number of time steps of `tolerances` with flips and without a rebuild.
    std::map<double, int> repaired;
    for (const Strategy strategy :
         {Strategy::tolerances, Strategy::automatic, Strategy::tolerances_each, Strategy::in_place})
        for (const std::string_view family : bench::families)
            for (const double spacings : {0.01, 0.03, 0.1, 0.3, 1.0}) {
                CAPTURE(name_of(strategy), family, spacings);
                // With twelve points repair is hardly ever given up: cavities are retriangulated, or cells flipped, at
                // any step size.
                for (const std::size_t n : {d == 2 ? 70U : 60U, 12U})
                    for_each_seed(1, [&](Random& random) {
                        bench::Scene<d> scene(family, "walk", n, spacings, random());
                        auto dt = moving<d>(scene.points(), strategy);
                        Moving_mesh<d> mesh(std::span<const Coordinates<d>>(scene.points()), dt.options());
                        for (int step = 0; step < 5; ++step) {
                            scene.step();
                            const Move_result report = dt.move_all(std::span<const Coordinates<d>>(scene.points()));
                            if (strategy == Strategy::tolerances && report.statistics.flips > 0 &&
                                report.moves.rebuilt == 0)
                                ++repaired[spacings];
                            check_cells<d>(dt);
                            mesh.move_all(std::span<const Coordinates<d>>(scene.points()));
                            REQUIRE(mesh.audit().delaunay());
                        }
                    });
            }
    for (const double spacings : {0.01, 0.03, 0.1, 0.3, 1.0}) {
        CAPTURE(spacings);
        CHECK(repaired[spacings] > 0);  // repair was tested
    }
}

TEMPLATE_TEST_CASE_SIG("Flips reach large steps without taking anything out, dimension", "[repair]", ((int d), d), 2,
                       3) {
    // Of thousands of vertices, including the hull, flips are stuck at a handful. The motion is slow enough for the
    // limit of repair.
    for_each_seed(2, [](Random& random) {
        bench::Scene<d> scene("uniform", "walk", 1500, d == 2 ? 0.05 : 0.01, random());
        auto dt = moving<d>(scene.points(), Strategy::tolerances);
        Move_result all;  // of the steps that were repaired
        std::uint64_t repaired = 0;
        for (int step = 0; step < 8; ++step) {
            scene.step();
            const Move_result report = dt.move_all(std::span<const Coordinates<d>>(scene.points()));
            if (report.moves.rebuilt > 0) continue;  // above the limit of repair
            all += report;
            ++repaired;
        }
        CHECK(dt.audit().delaunay());
        CHECK(repaired >= 6);
        CHECK(all.statistics.flips > repaired * 150);
        CHECK(all.statistics.undone_flips == 0);
        CHECK(all.moves.reinserted < all.moves.asked / 50);
    });
}

TEMPLATE_TEST_CASE_SIG("What one place needs costs another nothing: the cost a vertex does not grow, dimension",
                       "[repair]", ((int d), d), 2, 3) {
    const auto cost = [](std::size_t n) {
        bench::Scene<d> scene("uniform", "walk", n, d == 2 ? 0.03 : 0.01, 5);
        auto dt = moving<d>(scene.points(), Strategy::automatic);
        Move_result all;
        for (int step = 0; step < 6; ++step) {
            scene.step();
            const Move_result report = dt.move_all(std::span<const Coordinates<d>>(scene.points()));
            if (step > 1) all += report;
        }
        CHECK(all.moves.rebuilt == 0);
        return all.statistics.cost / static_cast<double>(all.moves.asked);
    };
    CHECK(cost(16000) < 1.3 * cost(1000));
}

TEMPLATE_TEST_CASE_SIG("A step that is clearly too expensive is given up before it is repaired, dimension", "[repair]",
                       ((int d), d), 2, 3) {
    constexpr std::size_t n = 2000;
    bench::Scene<d> slow("uniform", "walk", n, 1e-3, 3);
    auto dt = moving<d>(slow.points(), Strategy::automatic);
    for (int step = 0; step < 8; ++step) {
        slow.step();
        (void)dt.move_all(std::span<const Coordinates<d>>(slow.points()));
    }
    bench::Scene<d> elsewhere("uniform", "walk", n, 1e-3, 4);
    const Move_result report = dt.move_all(std::span<const Coordinates<d>>(elsewhere.points()));
    CHECK(report.statistics.sign_steps == 1);
    CHECK(report.moves.rebuilt == n);
    CHECK(report.statistics.undone_flips == 0);
    CHECK(report.statistics.cost < 1.2 * Rebuild_policy<d>::rebuild_cost(n));
    CHECK(dt.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("A step that is going to be rebuilt is given up early, dimension", "[repair][cost]",
                       ((int d), d), 2, 3) {
    constexpr std::size_t n = 2000;
    for (const auto& [family, spacings] : {std::pair{"uniform", 0.1}, {"faces", 0.01}, {"sphere", 0.01}}) {
        CAPTURE(family);
        // Of uniform points in 3D a sample tells before any sign is decided.
        const double most = d == 3 && std::string_view(family) == "uniform" ? 1.12 : 1.25;
        bench::Scene<d> scene(family, "walk", n, spacings, 1);
        auto dt = moving<d>(scene.points(), Strategy::automatic);
        for (int step = 0; step < 24; ++step) {
            CAPTURE(step);
            scene.step();
            const Move_result report = dt.move_all(std::span<const Coordinates<d>>(scene.points()));
            CHECK(report.statistics.cost < most * Rebuild_policy<d>::rebuild_cost(n));
        }
    }
}

TEMPLATE_TEST_CASE_SIG(
    "No time step costs more than one and a half rebuilds, whatever the points and the motion, dimension",
    "[repair][cost][deep]", ((int d), d), 2, 3) {
    for (const std::string_view family : bench::families)
        for (const std::string_view motion : bench::kinds_of_motion)
            for (const double spacings : {1e-4, 1e-2, 0.1, 1.0}) {
                CAPTURE(family, motion, spacings);
                for (const std::size_t n : {20U, 100U, 1000U}) {
                    CAPTURE(n);
                    bench::Scene<d> scene(family, motion, n, spacings, 3);
                    auto dt = moving<d>(scene.points(), Strategy::automatic);
                    for (int step = 0; step < 24; ++step) {
                        CAPTURE(step);
                        scene.step();
                        const Move_result report = dt.move_all(std::span<const Coordinates<d>>(scene.points()));
                        const double most = 1.5 * Cost_model<d>::insertion * static_cast<double>(n);
                        // A flip by the repair that was given up.
                        const double in_hand = 6.0 * Cost_model<d>::exact;
                        REQUIRE(report.statistics.cost < most + in_hand);
                        REQUIRE(report.statistics.tolerance_steps + report.statistics.sign_steps +
                                    report.statistics.rebuild_steps <=
                                1);
                    }
                    CHECK(dt.audit().delaunay());
                }
            }
}

TEST_CASE("auto rebuilds where that is the cheapest way, and comes back", "[repair]") {
    bench::Scene<3> large("uniform", "walk", 1000, 1.0, 1);
    auto dt = moving<3>(large.points(), Strategy::automatic);
    const auto steps = [&dt](bench::Scene<3>& scene, int n) {
        Move_result all;
        for (int step = 0; step < n; ++step) {
            scene.step();
            all += dt.move_all(std::span<const Coordinates<3>>(scene.points()));
        }
        return all;
    };
    CHECK(steps(large, 12).statistics.rebuild_steps == 12);
    // The same points at rest: after a few time steps nothing is rebuilt, and tolerances are kept.
    bench::Scene<3> quiet("uniform", "walk", 1000, 1e-5, 1);
    (void)steps(quiet, 2);
    const Move_result settled = steps(quiet, 12);
    CHECK(settled.moves.rebuilt == 0);
    CHECK(settled.statistics.tolerance_steps >= 8);
    CHECK(settled.statistics.tolerance_recomputations == 1);
    CHECK(steps(large, 12).statistics.rebuild_steps >= 10);
    CHECK(dt.audit().delaunay());
}

TEST_CASE("auto is the same run from the same input", "[repair]") {
    const auto run = [] {
        bench::Scene<3> scene("clusters", "walk", 500, 0.01, 9);
        auto dt = moving<3>(scene.points(), Strategy::automatic);
        std::vector<double> numbers;
        for (int step = 0; step < 20; ++step) {
            scene.step();
            const Move_result r = dt.move_all(std::span<const Coordinates<3>>(scene.points()));
            for (const auto k : {r.moves.rebuilt, r.moves.flipped, r.statistics.flips, r.statistics.evaluated,
                                 r.statistics.arithmetic.exact, r.statistics.sign_steps, r.statistics.rebuild_steps})
                numbers.push_back(static_cast<double>(k));
            numbers.push_back(r.statistics.cost);
        }
        return numbers;
    };
    CHECK(run() == run());
}

TEMPLATE_TEST_CASE_SIG("A vertex that goes where another is refused, however far, and nothing has changed, dimension",
                       "[repair]", ((int d), d), 2, 3) {
    for (const Strategy strategy : {Strategy::tolerances, Strategy::automatic})
        for_each_seed(10, [&](Random& random) {
            bench::Scene<d> scene("uniform", "walk", 50, 0.1, random());
            auto dt = moving<d>(scene.points(), strategy);
            const auto cells = cells_of(dt);
            const auto tolerance = dt.tolerance(0);
            for (Index to = 1; to < 50; ++to) {
                try {
                    dt.move(0, dt.points()[static_cast<std::size_t>(to)]);
                    FAIL("no duplicate point");
                } catch (const Error& e) {
                    CHECK(e.code() == Error_code::duplicate_point);
                }
            }
            CHECK(cells_of(dt) == cells);
            if (strategy == Strategy::tolerances) CHECK(dt.tolerance(0) == tolerance);
            check_cells<d>(dt);
        });
}

TEMPLATE_TEST_CASE_SIG(
    "Single moves to anywhere on a small grid leave neither a broken table nor a second border, dimension", "[repair]",
    ((int d), d), 2, 3) {
    // Degenerate everywhere: flips get stuck, cells below the hull are retriangulated, and vertices removed and
    // inserted again.
    const auto one = [](Random& random, Strategy strategy) {
        const auto place = [&random] {
            Coordinates<d> p;
            for (double& c : p) c = integer(random, 0, 3);
            return p;
        };
        std::vector<Coordinates<d>> x(8 + random() % 20);
        for (auto& p : x) p = place();
        Options options;
        options.strategy = strategy;
        options.merge_duplicates = true;
        Moving_of<d> dt(std::span<const Coordinates<d>>(x), options);
        if (dt.mesh().dimension() != d) return;
        for (int k = 0; k < 40; ++k) {
            try {
                dt.move(static_cast<Index>(random() % dt.number_of_vertices()), place());
            } catch (const Error& e) {
                REQUIRE(e.code() == Error_code::duplicate_point);
            }
            if (dt.mesh().dimension() != d) return;
            REQUIRE(dt.audit().first_fault == "");
            REQUIRE(dt.view_is_valid());
        }
    };
    for (const Strategy strategy : {Strategy::tolerances_each, Strategy::tolerances, Strategy::automatic})
        for_each_seed(60, [&](Random& random) { one(random, strategy); });
    Random once(621);  // the second border
    one(once, Strategy::tolerances_each);
}
