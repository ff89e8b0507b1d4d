// SPDX-License-Identifier: GPL-3.0-or-later
// Small sets on and near what is degenerate, built by several threads: in the build with tiny limits, where rounds of a
// few vertices are shared out, so that most cavities extend into another thread's partition.
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <support/small_sets.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("What several threads build of small sets is what one builds, dimension", "[parallel]",
                       ((int d), d), 2, 3) {
    Random random(run_seed());
    for (int k = 0; k < repeats(40); ++k)
        for (const auto set : all_small_sets) {
            const double off = k % 3 == 0 ? 0.0 : std::ldexp(1.0, -static_cast<int>(random() % 60));
            auto x = small_set<d>(set, 4 + random() % 120, off, random);
            std::set<Coordinates<d>> met;
            std::erase_if(x, [&](const auto& p) { return !met.insert(p).second; });
            const auto built = [&](int threads) {
                Options options;
                options.strategy = Strategy::rebuild;
                options.threads = threads;
                const Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
                REQUIRE(mesh.audit().delaunay());
                const Mesh_cells<d> cells = mesh.cells();
                return std::pair(cells.vertices, cells.neighbours);
            };
            CAPTURE(d, k, static_cast<int>(set), off);
            const auto alone = built(1);
            for (const int threads : {2, 5}) CHECK((built(threads) == alone));
        }
}
