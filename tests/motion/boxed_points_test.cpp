// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/boxed_points.h>
#include <apps/motion/crystal.h>

#include <support/catch.h>

#include <cmath>

using namespace annulus;

TEST_CASE("roots by arithmetic are roots, at every magnitude", "[motion]") {
    Portable_random dice(1);
    for (int i = 0; i < 3000; ++i) {
        const double x = std::ldexp(1 + dice.unit(), i % 900 - 450);
        CHECK(std::fabs(root_of<3>(x) / std::cbrt(x) - 1) < 0x1p-49);
        CHECK(root_of<2>(x) == std::sqrt(x));
    }
    for (const double x : {1.0, 2.0, 3.0, 0.125, 10.0, 1e50}) CHECK(std::fabs(root_of<3>(x * x * x) / x - 1) < 0x1p-49);
}

TEST_CASE("numbers of points that fit a box are the nearest that unit cells have", "[motion][periodic]") {
    Portable_random dice(2);
    for (int i = 0; i < 200; ++i) {
        const Box<3> box = Box<3>::orthorhombic({0.5 + dice.unit(), 0.5 + dice.unit(), 0.5 + 4 * dice.unit()});
        for (const auto& [name, crystal] : crystals) {
            if (dimension_of(crystal) != 3) continue;
            const std::size_t n = 1 + dice.below(3000);
            const auto cells = unit_cells<3>(box, crystal, n);
            if (cells) CHECK(crystal_in<3>(box, crystal, *cells).size() == n);
            const std::vector<std::size_t> fitting = numbers_that_fit<3>(box, crystal, n);
            REQUIRE(!fitting.empty());
            for (const std::size_t m : fitting) CHECK(unit_cells<3>(box, crystal, m));
            if (cells) CHECK(fitting.front() == n);
            if (fitting.size() == 2)
                for (std::size_t m = fitting[0] + 1; m < fitting[1]; ++m)
                    if (m != n) CHECK_FALSE(unit_cells<3>(box, crystal, m));
        }
    }
}

TEST_CASE("clusters grow with their box", "[motion][periodic]") {
    const auto unit = generate_in<3>(Box<3>::orthorhombic({1, 1, 1}), Point_family::clusters, 500, 4);
    const auto large = generate_in<3>(Box<3>::orthorhombic({8, 8, 8}), Point_family::clusters, 500, 4);
    for (std::size_t i = 0; i < unit.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) CHECK(std::fabs(large[i][k] - 8 * unit[i][k]) < 1e-14);
    CHECK(unit == generate<3>(Point_family::clusters, 500, 4));
}
