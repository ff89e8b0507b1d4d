// SPDX-License-Identifier: GPL-3.0-or-later
// After insertions, removals, moves and rebuilds a mesh has the cells of CGAL's triangulation: the program of
// fuzz/builds.cpp on random bytes.
#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>

#include <common/cgal_cells.h>
#include <common/mesh_case.h>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("A mesh has CGAL's cells after every change, dimension", "[kernel]", ((int d), d), 2, 3) {
    Random random(run_seed());
    for (int k = 0; k < repeats(400); ++k) {
        std::vector<std::uint8_t> bytes(20 + random() % 140);
        for (auto& b : bytes) b = static_cast<std::uint8_t>(random());
        bytes[1] = static_cast<std::uint8_t>(k);  // every kind of points
        oracle::Mesh_case<d> c((oracle::Bytes(bytes)));
        const std::string fault = c.fault();
        CAPTURE(d, k);
        INFO(c.points());
        REQUIRE(fault == "");
    }
}
