// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres computed for four cells at a time equal those of single cells, bit for bit, in and out of the range of their
// bounds.
#include <annulus/kernel/cached_spheres.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>

#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("Spheres of four cells at a time are those of one, whatever their size", "[kernel]") {
    Random random(3);
    const auto size = [&random] { return std::ldexp(1.0 + unit(random), integer(random, -230, 70)); };
    for (int k = 0; k < repeats(2000); ++k) {
        const auto count = static_cast<std::size_t>(integer(random, 1, 9));
        const bool alike = random() % 2 == 0;
        Growing_cells<3> g;
        g.infinity = static_cast<Growing_cells<3>::Rank>(3 * count + 1);
        g.sites.resize(3 * count + 2);
        g.make_room(count);
        for (auto& s : g.sites) s = {{unit(random), unit(random), unit(random)}, 1.0};
        const Coordinates<3> p = g.sites[0].x;
        for (std::size_t c = 0; c < count; ++c) {
            const double scale = alike ? 1.0 : size();
            for (std::size_t i = 0; i < 3; ++i) {
                const auto v = 3 * c + i + 1;
                for (std::size_t j = 0; j < 3; ++j) g.sites[v].x[j] = p[j] + scale * (unit(random) - 0.5);
                g.cells[c].vertex[i + 1] = static_cast<Growing_cells<3>::Rank>(v);
            }
            g.cells[c].vertex[0] = 0;
        }
        std::vector<std::uint32_t> made(count);
        std::iota(made.begin(), made.end(), 0U);
        cached_spheres(g, made);
        for (std::size_t c = 0; c < count; ++c) {
            const auto& v = g.cells[c].vertex;
            float bound = 0;
            const Cached_sphere<3> one = cached_sphere(g.lifted(v[1], p), g.lifted(v[2], p), g.lifted(v[3], p), bound);
            CAPTURE(k, c);
            REQUIRE(std::bit_cast<std::uint32_t>(bound) == std::bit_cast<std::uint32_t>(g.bounds[c]));
            REQUIRE(std::bit_cast<std::array<std::uint64_t, 4>>(one) ==
                    std::bit_cast<std::array<std::uint64_t, 4>>(g.cells[c].sphere));
        }
    }
}
