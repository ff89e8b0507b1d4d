// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/read_neighbours.h>
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/nodt_3.h>
#include <apps/motion/surface_3.h>

#include <motion/shapes.h>
#include <support/at_once.h>
#include <support/catch.h>
#include <support/motions.h>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("One Lloyd and one natural ODT may be called by several threads, with threads of their own", "[threads]") {
    Random random(5);
    const Long_motion<2> plane(Motion_kind::jitter, 2000, random);
    const Moving_delaunay_2 dt2(plane.positions());
    const Lloyd_2 lloyd(Domain_2::square(1), Density::one, 2);
    Neighbours_2 neighbours;
    read_neighbours(dt2.mesh(), dt2.positions(), neighbours);
    const auto lloyd_targets = [&] {
        std::vector<Coordinates<2>> target(plane.positions().size());
        (void)lloyd.step(neighbours, plane.positions(), target);
        return target;
    };
    const auto alone2 = lloyd_targets();
    for (const auto& s : at_once(lloyd_targets)) CHECK((s == alone2));

    const Surface_3 box(annulus_test::box({0.9, 0.9, 0.9}));
    const std::vector<Coordinates<3>> space = annulus_test::random_points(1500, 7);
    const Mesh_cells<3> cells = linked(Moving_delaunay_3(space).audit_input().cells, space.size());
    const Nodt_3 nodt(box, Sizing_3(box, 1), vertices_on_surface(box, space), {}, 2);
    const auto nodt_targets = [&] {
        std::vector<Coordinates<3>> target(space.size());
        (void)nodt.step(cells, cells_inside(box, cells, space, 2), space, target);
        return target;
    };
    const auto alone3 = nodt_targets();
    for (const auto& s : at_once(nodt_targets)) CHECK((s == alone3));
}
