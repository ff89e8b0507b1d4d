// SPDX-License-Identifier: GPL-3.0-or-later
// Four cells at a time are clear where each of them is by itself.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/certificates.h>
#include <annulus/mesh/clear_cells.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/repeats.h>
#include <support/small_sets.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
bool is_clear(const Corner_table<d>& t, const std::vector<Coordinates<d>>& x, Cell_index c) {
    using Sphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;
    const auto at = [&](Index v) -> const Coordinates<d>& { return x[static_cast<std::size_t>(v)]; };
    const Cell_sites<d> v = cell_sites(t, c);
    const auto beyond = [&](std::size_t k) -> const Coordinates<d>& {
        const Index o = t.opposite(t.corner(c, static_cast<int>(k))).vertex;
        return at(o == infinite ? v[0].vertex : o);
    };
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        return Sphere(at(v[i].vertex)...).excludes_all(beyond(i)...);
    }
    (std::make_index_sequence<d + 1>());
}

/// Moves the points of a mesh, so that some cells are inverted and some facets violated, and compares.
template <int d>
void check(std::vector<Coordinates<d>> x, double pace, Random& random) {
    Delaunay_mesh<d> mesh;
    try {
        mesh.build(x);
    } catch (const Error&) {  // duplicate points
        return;
    }
    if (mesh.dimension() < d) return;
    for (auto& p : x)
        for (double& c : p) c += pace * between(random, -1.0, 1.0);
    const Corner_table<d>& t = mesh.table();
    const Cell_index first(static_cast<Index>(random() % 3));
    std::vector<Cell_index> rest;
    const std::size_t count = clear_cells<d>(t, x, first, t.cell_bound(), rest);
    std::sort(rest.begin(), rest.end());
    std::size_t clear = 0, untested = 0;
    for (Cell_index c = first; c < t.cell_bound(); ++c) {
        if (!t.is_cell(c)) continue;
        const bool listed = std::binary_search(rest.begin(), rest.end(), c);
        const bool is = !t.is_infinite(c) && is_clear<d>(t, x, c);
        clear += listed ? 0U : 1U;
        untested += is && listed ? 1U : 0U;
        REQUIRE((is || listed));
    }
    REQUIRE(count == clear);
    REQUIRE(untested <= 3);
    REQUIRE(std::adjacent_find(rest.begin(), rest.end()) == rest.end());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Four cells at a time are clear where each is by itself, dimension", "[engine]", ((int d), d), 2,
                       3) {
    if (!has_fast_clear_cells()) return;
    Random random(11);
    for (int i = 0; i < repeats(200); ++i) {
        const double scale = std::ldexp(1.0, integer(random, -80, 80));
        const double pace = std::ldexp(1.0, integer(random, -60, 0));
        std::vector<Coordinates<d>> x(5 + random() % 60);
        const bool lattice = random() % 2 == 0;
        for (auto& p : x)
            for (double& c : p) c = scale * (lattice ? integer(random, 0, 5) : between(random, 0.0, 1.0));
        check<d>(x, pace * scale, random);
    }
}
