// SPDX-License-Identifier: GPL-3.0-or-later
// The energy of Voronoi cells, against integrals in closed form.
#include <apps/motion/cell_energy.h>
#include <apps/motion/domain_2.h>

#include <support/catch.h>

#include <cmath>
#include <numbers>

using namespace annulus;

namespace {

double energy(Density density, const Domain_2& domain, const Coordinates<2>& site) {
    return cell_energy(density, domain.whole(site), site);
}

bool close(double a, double b, double share) { return std::fabs(a - b) <= share * std::fabs(b); }

}  // namespace

TEST_CASE("The energy of polynomial densities in a square is exact", "[motion]") {
    const Domain_2 square = Domain_2::square(1);
    CHECK(close(energy(Density::one, square, {0, 0}), 8.0 / 3, 1e-14));
    // Steiner: the squared distance to the centre and the area are added.
    CHECK(close(energy(Density::one, square, {0.5, -0.25}), 8.0 / 3 + 4 * 0.3125, 1e-14));
    // The integrals of x^2 (x^2 + y^2) and (x^2 + y^2)^2 over the square.
    CHECK(close(energy(Density::x2, square, {0, 0}), 4.0 / 5 + 4.0 / 9, 1e-14));
    CHECK(close(energy(Density::x2_plus_y2, square, {0, 0}), 8.0 / 5 + 8.0 / 9, 1e-14));
}

TEST_CASE("The energy of a disc is that of its outline", "[motion]") {
    const double pi = std::numbers::pi;
    const Domain_2 disc = Domain_2::disc(2);
    CHECK(close(energy(Density::one, disc, {0, 0}), pi * 16 / 2, 2e-4));
    CHECK(close(energy(Density::one, disc, {1, 0}), pi * 16 / 2 + pi * 4, 2e-4));
    for (const auto& p : outline_of(disc.whole({1, 0.5}))) CHECK(std::fabs(std::hypot(p[0], p[1]) - 2) < 1e-12);
    CHECK(outline_of(disc.whole({0, 0})).size() >= 314);
    CHECK(outline_of(Domain_2::square(1).whole({0, 0})).size() == 4);
}

TEST_CASE("An empty cell has no energy", "[motion]") { CHECK(cell_energy(Density::one, Cell_2{}, {0, 0}) == 0); }
