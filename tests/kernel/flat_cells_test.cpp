// SPDX-License-Identifier: GPL-3.0-or-later
// Points on a line or in a plane in 3D: the cells are those of CGAL.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <annulus/error.h>
#include <annulus/kernel/flat_cells.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <support/small_sets.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Triangle = std::array<Index, 3>;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

std::set<Triangle> by_cgal(const std::vector<Coordinates<3>>& x) {
    CGAL::Delaunay_triangulation_3<Kernel> tr;
    std::map<Coordinates<3>, Index> index;
    for (std::size_t i = 0; i < x.size(); ++i) {
        index.emplace(x[i], static_cast<Index>(i));
        tr.insert(Kernel::Point_3(x[i][0], x[i][1], x[i][2]));
    }
    std::set<Triangle> triangles;
    if (tr.dimension() == 2)
        for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f) {
            Triangle t{};
            for (int k = 0; k < 3; ++k) {
                const auto& p = f->first->vertex(k)->point();
                t[static_cast<std::size_t>(k)] = index.at({p.x(), p.y(), p.z()});
            }
            std::sort(t.begin(), t.end());
            triangles.insert(t);
        }
    return triangles;
}

std::vector<Index> all_of(std::size_t n) {
    std::vector<Index> vertices(n);
    std::iota(vertices.begin(), vertices.end(), Index{0});
    return vertices;
}

void check_plane(const std::vector<Coordinates<3>>& x) {
    const Flat_cells flat = flat_cells<3>(x, all_of(x.size()));
    const std::set<Triangle> expected = by_cgal(x);
    REQUIRE((flat.dimension == 2) == !expected.empty());
    if (flat.dimension != 2) return;
    std::set<Triangle> triangles;
    for (std::size_t k = 0; k < flat.vertices.size(); ++k) {
        Triangle t = flat.vertices[k];
        for (std::size_t i = 0; i < 3; ++i) {  // a neighbour shares the edge, and runs through it the other way
            const auto n = static_cast<std::size_t>(flat.neighbours[k][i]);
            const auto& other = flat.vertices[n];
            const auto& back = flat.neighbours[n];
            const auto j =
                static_cast<std::size_t>(std::find(back.begin(), back.end(), static_cast<Index>(k)) - back.begin());
            REQUIRE(j < 3);
            REQUIRE(t[(i + 1) % 3] == other[(j + 2) % 3]);
            REQUIRE(t[(i + 2) % 3] == other[(j + 1) % 3]);
        }
        std::sort(t.begin(), t.end());
        if (t[0] != infinite) REQUIRE(triangles.insert(t).second);
    }
    REQUIRE(triangles == expected);
}

}  // namespace

TEST_CASE("Points in a plane of space have CGAL's triangles, whatever the plane and however degenerate",
          "[kernel][flat]") {
    Random random(run_seed());
    // u, v -> a plane whose points are doubles for all small multiples u, v of a power of two.
    const std::vector<std::array<std::array<double, 3>, 2>> planes{
        {{{1, 0, 0}, {0, 1, 0}}},  {{{0, 1, 0}, {0, 0, 1}}},  {{{0, 0, 1}, {1, 0, 0}}},
        {{{1, 0, 1}, {0, 1, -2}}}, {{{3, 1, 2}, {-1, 5, 4}}}, {{{1, 1, 1}, {1, -1, 0}}}};
    for (int k = 0; k < repeats(200); ++k)
        for (const auto& [u, v] : planes) {
            const int scale = k % 3 == 0 ? static_cast<int>(random() % 600) - 300 : 0;
            const int extent = k % 2 == 0 ? 3 : 1000;
            const double offset = k % 5 == 0 ? 1e6 : 0.0;
            std::set<Coordinates<3>> distinct;
            for (std::size_t n = 1 + random() % 40; n > 0; --n) {
                const double a = integer(random, 0, extent), b = integer(random, 0, extent);
                Coordinates<3> p;
                for (std::size_t c = 0; c < 3; ++c) p[c] = std::ldexp(offset + a * u[c] + b * v[c], scale);
                distinct.insert(p);
            }
            std::vector<Coordinates<3>> x(distinct.begin(), distinct.end());
            std::shuffle(x.begin(), x.end(), random);
            CAPTURE(k, u, v, scale, extent, offset);
            check_plane(x);
        }
}

TEMPLATE_TEST_CASE_SIG("Points on a line have the segments between neighbours, dimension", "[kernel][flat]",
                       ((int d), d), 2, 3) {
    std::vector<Coordinates<d>> x;
    for (const double t : {4.0, -1.0, 2.5, 0.0, 1e9, 3.0}) {
        Coordinates<d> p;
        for (std::size_t c = 0; c < d; ++c) p[c] = t * static_cast<double>(c) - 1;
        x.push_back(p);
    }
    const Flat_cells flat = flat_cells<d>(x, all_of(x.size()));
    CHECK(flat.dimension == 1);
    const std::vector<Index> ring{infinite, 1, 3, 2, 5, 0, 4, infinite};
    REQUIRE(flat.vertices.size() == 7);
    for (std::size_t k = 0; k < 7; ++k) {
        CHECK(flat.vertices[k] == std::array<Index, 3>{ring[k], ring[k + 1], none});
        CHECK(flat.neighbours[k] ==
              std::array<Index, 3>{static_cast<Index>((k + 1) % 7), static_cast<Index>((k + 6) % 7), none});
    }
    CHECK(flat_cells<d>(x, {4}).dimension == 0);
    CHECK(flat_cells<d>(x, {}).dimension == -1);
    require_distinct<d>(x, all_of(x.size()));
    x.push_back(x[2]);
    try {
        require_distinct<d>(x, all_of(x.size()));
        FAIL("two points at one place");
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::duplicate_point);
        CHECK(std::vector(e.vertices().begin(), e.vertices().end()) == std::vector<std::int64_t>{2, 6});
    }
}
