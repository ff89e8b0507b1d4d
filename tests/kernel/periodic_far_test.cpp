// SPDX-License-Identifier: GPL-3.0-or-later
// Points that are given many boxes away, on a side of the box up to rounding: their places are not all in the cell of
// the basis.
#include <annulus/periodic_mesh.h>

#include <support/catch.h>

#include <cstddef>
#include <vector>

using namespace annulus;

namespace {

template <int d>
void expect_whole(const Periodic_mesh<d>& mesh) {
    CHECK(mesh.audit().delaunay());
    CHECK(mesh.voronoi_volumes().size() == mesh.points().size());
}

}  // namespace

TEST_CASE("A point on a side of the box, thousands of boxes away, is one point of the box", "[kernel][periodic]") {
    int far = 0;
    for (const double length : {0.3, 0.7, 5.43, 3.615})
        for (int boxes = 1; boxes < 3'000'000; boxes = 3 * boxes + 1)
            for (const double sign : {-1.0, 1.0}) {
                const double x = sign * boxes * length;
                CAPTURE(length, x);
                const auto square = Box<2>::orthorhombic({length, length});
                Periodic_mesh<2> one(std::vector<Coordinates<2>>{{x, 0.3 * length}}, square);
                expect_whole<2>(one);
                one.move_all(std::vector<Coordinates<2>>{{-x, x}});
                expect_whole<2>(one);
                Periodic_mesh<2> line(std::vector<Coordinates<2>>{{x, 0}, {x, 0.3 * length}, {x, 0.6 * length}},
                                      square);
                expect_whole<2>(line);
                const auto cube = Box<3>::orthorhombic({length, length, length});
                std::vector<Coordinates<3>> fcc{{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};
                for (auto& p : fcc) {
                    for (double& c : p) c *= length;
                    p[0] += x;
                }
                expect_whole<3>(Periodic_mesh<3>(fcc, cube));
                ++far;
            }
    CHECK(far > 50);
}
