// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres computed for four cells at a time equal those of single cells, bit for bit, in and out of the range of their
// bounds.
#include <annulus/kernel/cached_spheres.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>

#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("Spheres of four cells at a time are those of one, whatever their size, dimension", "[kernel]",
                       ((int d), d), 2, 3) {
    Random random(3);
    const auto size = [&random] { return std::ldexp(1.0 + unit(random), integer(random, -230, 70)); };
    for (int k = 0; k < repeats(2000); ++k) {
        const auto count = static_cast<std::size_t>(integer(random, 1, 9));
        const bool alike = random() % 2 == 0;
        Growing_cells<d> g;
        using Rank = typename Growing_cells<d>::Rank;
        g.infinity = static_cast<Rank>(d * count + 1);
        g.sites.resize(d * count + 2);
        g.make_room(count);
        for (auto& s : g.sites) {
            for (double& c : s.x) c = unit(random);
            s.grid = 1.0;
        }
        const Coordinates<d> p = g.sites[0].x;
        for (std::size_t c = 0; c < count; ++c) {
            const double scale = alike ? 1.0 : size();
            for (std::size_t i = 0; i < d; ++i) {
                const auto v = d * c + i + 1;
                for (std::size_t j = 0; j < d; ++j) g.sites[v].x[j] = p[j] + scale * (unit(random) - 0.5);
                g.cells[c].vertex[i + 1] = static_cast<Rank>(v);
            }
            g.cells[c].vertex[0] = 0;
        }
        std::vector<std::uint32_t> made(count);
        std::iota(made.begin(), made.end(), 0U);
        cached_spheres(g, made);
        for (std::size_t c = 0; c < count; ++c) {
            const auto lifted = [&](std::size_t i) { return g.lifted(g.cells[c].vertex[i], p); };
            float bound = 0;
            Cached_sphere<d> one;
            if constexpr (d == 2) one = cached_sphere(lifted(1), lifted(2), bound);
            else one = cached_sphere(lifted(1), lifted(2), lifted(3), bound);
            CAPTURE(d, k, c);
            REQUIRE(std::bit_cast<std::uint32_t>(bound) ==
                    std::bit_cast<std::uint32_t>(g.bound(static_cast<std::uint32_t>(c))));
            using Bits = std::array<std::uint64_t, static_cast<std::size_t>(d + 1)>;
            REQUIRE(std::bit_cast<Bits>(one) == std::bit_cast<Bits>(g.cells[c].sphere));
        }
    }
}
