// SPDX-License-Identifier: GPL-3.0-or-later
// Time steps in several threads. Not a part of the tests under ThreadSanitizer, which does not see how TBB's library,
// built without it, hands a task to another thread, and calls that a race.
#include <annulus/moving_mesh.h>

#include "../../bench/motions/families.h"

#include <support/catch.h>
#include <support/viewed_mesh.h>

#include <vector>

using namespace annulus;

namespace {

/// The contents of all reports, and the cells at the end. Enough cells for several runs.
template <int d>
std::vector<double> walked(int with, Strategy strategy, double spacings) {
    bench::Scene<d> scene("uniform", "walk", d == 2 ? 12000 : 4000, spacings, 3);
    Options options;
    options.strategy = strategy;
    options.threads = with;
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(scene.points()), options);
    testing::Viewed_mesh<d> dt(std::span<const Coordinates<d>>(scene.points()), options);
    std::vector<double> said;
    const auto say = [&said](const Move_result& r) {
        for (const auto n :
             {r.moves.within_tolerance, r.moves.kept_in_place, r.moves.flipped, r.moves.reinserted, r.moves.rebuilt,
              r.statistics.evaluated, r.statistics.arithmetic.filter, r.statistics.arithmetic.interval,
              r.statistics.arithmetic.exact, r.statistics.flips, r.statistics.sign_steps, r.statistics.rebuild_steps})
            said.push_back(static_cast<double>(n));
        said.push_back(r.statistics.cost);
    };
    for (int step = 0; step < 8; ++step) {
        scene.step();
        say(mesh.move_all(scene.points()));
        say(dt.move_all(std::span<const Coordinates<d>>(scene.points())));
    }
    for (const auto& cell : mesh.cells().vertices) said.insert(said.end(), cell.begin(), cell.end());
    for (const auto& cell : dt.audit_input().cells) said.insert(said.end(), cell.begin(), cell.end());
    return said;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG(
    "Time steps in several threads are those in one, counters and order of cells included, dimension",
    "[parallel][deep]", ((int d), d), 2, 3) {
    for (const Strategy strategy : {Strategy::automatic, Strategy::tolerances})
        for (const double spacings : {3e-3, 0.05}) {
            const auto alone = walked<d>(1, strategy, spacings);
            for (const int with : {2, 3, 5}) CHECK((walked<d>(with, strategy, spacings) == alone));
        }
}
