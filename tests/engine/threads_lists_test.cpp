// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of a Moving_mesh, requested by several threads at once.
#include <annulus/moving_mesh.h>

#include <support/at_once.h>
#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>

#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("Several threads may request lists at once, dimension", "[lists][threads]", ((int d), d), 2, 3) {
    Random random(8);
    std::vector<Coordinates<d>> x(40);
    for (int step = 0; step < repeats(10); ++step) {
        for (auto& p : x)
            for (double& c : p) c = between(random, 0, 1);
        const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
        const auto said = at_once([&] {
            std::vector<Index> all = mesh.find_cells(x);
            for (Index v = 0; v < 40; ++v)
                for (const Index w : mesh.neighbors(v)) all.push_back(w);
            for (const auto& facet : mesh.convex_hull()) all.insert(all.end(), facet.begin(), facet.end());
            return all;
        });
        for (const auto& one : said) CHECK(one == said.front());
    }
}
