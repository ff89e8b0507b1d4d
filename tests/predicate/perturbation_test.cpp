// SPDX-License-Identifier: GPL-3.0-or-later
// The symbolic perturbation compared with CGAL's.

#include <annulus/predicate/perturbed_sign.h>

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cgal_triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

Kernel::Point_2 cgal(const Point& p) { return {p[0], p[1]}; }
Point ours(const Kernel::Point_2& p) { return {p.x(), p.y()}; }

struct Reach_into : Cgal_triangulation {
    using Cgal_triangulation::side_of_oriented_circle;
};

/// CGAL's result: positive when p is outside the circle of a, b, q, perturbed.
int cgal_sign(const Bicell& c) {
    static const Reach_into cgal_triangulation;
    return -cgal_triangulation.side_of_oriented_circle(cgal(c.a), cgal(c.b), cgal(c.q), cgal(c.p), true);
}

void check_like_cgal(const Bicell& c) {
    const int sign = perturbed_sign(c.tuple());
    HOLDS(sign == 1 || sign == -1, c);
    HOLDS(sign == cgal_sign(c), c);
    HOLDS(sign == perturbed_sign(c.turned().tuple()), c);
    HOLDS(sign == -perturbed_sign(c.flipped().tuple()), c);
    const Points copies{c.q, c.p, c.b, c.a};  // positions decide, not addresses
    HOLDS(sign == perturbed_sign({&copies[3], &copies[2], &copies[1], &copies[0]}), c);
    // The circle of the positive triangle a b q has no first point.
    HOLDS(sign == cgal_sign({c.b, c.q, c.p, c.a}), c);
}

Bicell grid_square(Random& random) {
    for (;;) {
        const Point corner{static_cast<double>(integer(random, -99, 99)),
                           static_cast<double>(integer(random, -99, 99))};
        const double x = integer(random, -5, 5), y = integer(random, -5, 5), ratio = integer(random, 1, 3);
        // A rectangle of any direction and of sides 1 : ratio, along its diagonal.
        const Bicell c{corner,
                       {corner[0] + x - ratio * y, corner[1] + y + ratio * x},
                       {corner[0] + x, corner[1] + y},
                       {corner[0] - ratio * y, corner[1] + ratio * x}};
        if (is_bicell(c)) return random() % 2 == 0 ? c : c.flipped();
    }
}

/// The number of cocircular edges, all of them right.
int check_triangulation(const Points& points) {
    std::vector<Kernel::Point_2> input;
    for (const Point& p : points) input.push_back(cgal(p));
    const Cgal_triangulation t(input.begin(), input.end());
    int cocircular = 0;
    for (auto e = t.finite_edges_begin(); e != t.finite_edges_end(); ++e) {
        const auto cell = e->first;
        const int i = e->second;
        if (t.is_infinite(cell) || t.is_infinite(cell->neighbor(i))) continue;
        const Bicell c{ours(cell->vertex(t.ccw(i))->point()), ours(cell->vertex(t.cw(i))->point()),
                       ours(t.mirror_vertex(cell, i)->point()), ours(cell->vertex(i)->point())};
        const int sign = all_stages(c).sign;
        HOLDS(sign >= 0, c);
        if (sign > 0) continue;
        ++cocircular;
        HOLDS(perturbed_sign(c.tuple()) == 1, c);
    }
    return cocircular;
}

}  // namespace

TEST_CASE("cocircular points are decided as CGAL decides them, never 0, from both sides alike", "[certificate]") {
    REQUIRE(for_all("on Pythagorean points", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) check_like_cgal(bicell(Bicell_family::cocircular_exact, random));
    }));
    REQUIRE(for_all("on rectangles of a grid", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) check_like_cgal(grid_square(random));
    }));
}

TEST_CASE("every edge of a triangulation by CGAL has an empty circle, perturbed where cocircular", "[certificate]") {
    int cocircular = 0;
    int cases = 0;  // RC_PARAMS decides how many
    REQUIRE(for_all("on grids", [&cocircular, &cases](const Seed& seed) {
        ++cases;
        Random random = seed.random();
        const auto n = static_cast<std::size_t>(integer(random, 25, 100));
        cocircular += check_triangulation(point_set(Family::grid, n, random));
    }));
    CHECK(cocircular > 10 * cases);
    cocircular = 0;
    cases = 0;
    REQUIRE(for_all("on Pythagorean points", [&cocircular, &cases](const Seed& seed) {
        ++cases;
        Random random = seed.random();
        const auto n = static_cast<std::size_t>(integer(random, 25, 100));
        cocircular += check_triangulation(point_set(Family::cocircular_exact, n, random));
    }));
    CHECK(cocircular > 10 * cases);
}

TEST_CASE("the four corners of the unit square, by hand", "[certificate]") {
    // In lexicographic order 00 < 01 < 10 < 11. The greatest is 11 = (1, 1): it counts as outside the circle of the
    // others, so the diagonal that stays is the one that misses it.
    const Bicell missing{{0, 1}, {1, 0}, {0, 0}, {1, 1}};
    REQUIRE(is_bicell(missing));
    CHECK(perturbed_sign(missing.tuple()) == 1);
    CHECK(perturbed_sign(missing.turned().tuple()) == 1);
    CHECK(perturbed_sign(missing.flipped().tuple()) == -1);
}
