// SPDX-License-Identifier: GPL-3.0-or-later
// Cavities with more points than Cavity_retriangulator keeps memory for: they and later ones are retriangulated.
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators.h>

#include <cmath>
#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("A hub of 17,000 neighbours goes, comes back and goes again, dimension", "[kernel][local]",
                       ((int d), d), 2, 3) {
    Random random(4);
    std::vector<Coordinates<d>> x(1, Coordinates<d>{});  // the hub; all others are about as far from it
    while (x.size() < 17'001) {
        Coordinates<d> p{};
        double squares = 0.0;
        for (double& c : p) {
            c = between(random, -1.0, 1.0);
            squares += c * c;
        }
        if (squares < 0.01 || squares > 1.0) continue;
        for (double& c : p) c /= std::sqrt(squares);
        x.push_back(p);
    }
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), Options{.strategy = Strategy::automatic});
    for (int time = 0; time < 2; ++time) {
        mesh.remove(0);
        REQUIRE(mesh.audit().delaunay());
        REQUIRE(mesh.insert(x[0]) == 0);
        REQUIRE(mesh.audit().delaunay());
    }
    mesh.remove(1);  // a small cavity, with fresh memory
    CHECK(mesh.audit().delaunay());
}
