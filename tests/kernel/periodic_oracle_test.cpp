// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic triangulations of few points, by brute force in rational numbers, and by the audit.
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/periodic_oracle.h>
#include <support/repeats.h>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
void compare_with_oracle(std::uint64_t seed, std::size_t most) {
    Periodic_cases cases(seed);
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (std::size_t n = 1; n <= most; ++n) {
            CAPTURE(seed, kind, n);
            const Box<d> box = cases.box<d>(kind);
            const Periodic_mesh<d> mesh(cases.points<d>(box, n), box);
            const auto input = mesh.audit_input();
            const std::string fault = Periodic_oracle<d>(input).fault();
            CHECK(fault.empty());
            const Audit_result audit = mesh.audit();
            CHECK(audit.first_fault.empty());
            CHECK(audit.delaunay());
            if (d == 2) CHECK(mesh.number_of_cells() == 2 * n);
        }
}

}  // namespace

TEST_CASE("Periodic triangulations in 2D are those of brute force, from one point on, in ten kinds of boxes",
          "[kernel][periodic]") {
    for (int k = 0; k < repeats(3); ++k) compare_with_oracle<2>(static_cast<std::uint64_t>(k) + 1, 12);
}

TEST_CASE("Periodic triangulations in 3D are those of brute force, from one point on, in ten kinds of boxes",
          "[kernel][periodic]") {
    for (int k = 0; k < repeats(1); ++k) compare_with_oracle<3>(static_cast<std::uint64_t>(k) + 1, 12);
}

TEST_CASE("One point in a cube has six tetrahedra around it, and no points have no cells", "[kernel][periodic]") {
    const Box<3> cube = Box<3>::orthorhombic({1, 1, 1});
    CHECK(Periodic_mesh<3>(std::vector<Coordinates<3>>{{0.25, 0.5, 0.75}}, cube).number_of_cells() == 6);
    const Periodic_mesh<3> nothing(std::vector<Coordinates<3>>{}, cube);
    CHECK(nothing.number_of_cells() == 0);
    CHECK(nothing.audit().delaunay());
    CHECK(nothing.neighbours().first.empty());
    CHECK(nothing.voronoi_volumes().empty());
}
