// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic perturbation in 3D compared with CGAL's.

#include <annulus/predicate/perturbed_sign.h>

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages_3.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <set>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal_triangulation = CGAL::Delaunay_triangulation_3<Kernel>;

Kernel::Point_3 cgal(const Point_3& p) { return {p[0], p[1], p[2]}; }
Point_3 ours(const Kernel::Point_3& p) { return {p.x(), p.y(), p.z()}; }

struct Reach_into : Cgal_triangulation {
    using Cgal_triangulation::side_of_oriented_sphere;
};

/// CGAL's result: positive when p is outside the sphere of a, b, c, q, perturbed.
int cgal_sign(const Bicell_3& c) {
    static const Reach_into t;
    return -t.side_of_oriented_sphere(cgal(c.a), cgal(c.b), cgal(c.c), cgal(c.q), cgal(c.p), true);
}

void check_like_cgal(const Bicell_3& c) {
    const int sign = perturbed_sign(c.tuple());
    HOLDS(sign == 1 || sign == -1, c);
    HOLDS(sign == cgal_sign(c), c);
    HOLDS(sign == perturbed_sign(c.turned().tuple()), c);
    HOLDS(sign == perturbed_sign(c.rotated().tuple()), c);
    const std::vector<Point_3> copies{c.q, c.p, c.c, c.b, c.a};  // positions decide, not addresses
    HOLDS(sign == perturbed_sign({&copies[4], &copies[3], &copies[2], &copies[1], &copies[0]}), c);
}

/// The number of cospherical facets, all of them right.
int check_triangulation(const std::set<Point_3>& points) {
    std::vector<Kernel::Point_3> input;
    for (const Point_3& p : points) input.push_back(cgal(p));
    const Cgal_triangulation t(input.begin(), input.end());
    int cospherical = 0;
    for (auto f = t.finite_facets_begin(); f != t.finite_facets_end(); ++f) {
        const auto cell = f->first;
        const auto other = cell->neighbor(f->second);
        if (t.is_infinite(cell) || t.is_infinite(other)) continue;
        const auto corner = [&](int i) { return ours(cell->vertex(t.vertex_triple_index(f->second, i))->point()); };
        Bicell_3 c{corner(0), corner(1), corner(2), ours(t.mirror_vertex(cell, f->second)->point()),
                   ours(cell->vertex(f->second)->point())};
        if (exact_orientation(c.a, c.b, c.c, c.q) < 0) std::swap(c.a, c.b);
        HOLDS(exact_orientation(c.a, c.b, c.c, c.q) > 0 && exact_orientation(c.b, c.a, c.c, c.p) > 0, c);
        const int sign = evaluate_empty_sphere(c.tuple()).sign;
        HOLDS(sign >= 0, c);
        if (sign > 0) continue;
        ++cospherical;
        HOLDS(perturbed_sign(c.tuple()) == 1, c);
    }
    return cospherical;
}

}  // namespace

TEST_CASE("cospherical points are decided as CGAL decides them, never 0, from both sides alike",
          "[certificate][space]") {
    REQUIRE(for_all("on integer points of one norm", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) {
            const Bicell_3 c = bicell(Family_3::cospherical_exact, random);
            if (empty_sphere_exact(c.tuple()).sign == 0) check_like_cgal(c);
        }
    }));
    int seen = 0;
    int cases = 0;
    REQUIRE(for_all("on corners of cubes", [&](const Seed& seed) {
        ++cases;
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) {
            const Bicell_3 c = bicell(Family_3::grid, random);
            if (empty_sphere_exact(c.tuple()).sign == 0) check_like_cgal(c), ++seen;
        }
    }));
    CHECK(seen > cases);
}

TEST_CASE("every facet of a triangulation of a grid by CGAL has an empty sphere, perturbed where cospherical",
          "[certificate][space]") {
    int cospherical = 0;
    int cases = 0;  // RC_PARAMS decides how many
    REQUIRE(for_all("on grids", [&](const Seed& seed) {
        ++cases;
        Random random = seed.random();
        std::set<Point_3> points;
        const int n = integer(random, 20, 60);
        for (int i = 0; i < n; ++i) {
            Point_3 p;
            for (double& c : p) c = integer(random, 0, 3);
            points.insert(p);
        }
        cospherical += check_triangulation(points);
    }));
    CHECK(cospherical > 10 * cases);
}
