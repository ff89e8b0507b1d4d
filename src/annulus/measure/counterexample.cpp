// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/counterexample.h>

#include <annulus/engine/displacement.h>
#include <annulus/error.h>
#include <annulus/predicate/filtered.h>
#include <annulus/predicate/theta.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace annulus::inline v1 {

namespace {

using Point = Coordinates<3>;
/// a and b on the axis; p, q and r around them.
struct Five_points {
    Point a, b, p, q, r;
};

/// a, b = (0, 0, +-height), and p, q, r at 120 degrees on a circle of z = 0.
Five_points five_points(double height, double radius) {
    const double x = -0.5 * radius;
    const double y = 0.5 * std::sqrt(3.0) * radius;
    return {{0, 0, height}, {0, 0, -height}, {radius, 0, 0}, {x, y, 0}, {x, -y, 0}};
}

/// The three facets at a b with their opposite vertices, and the three cells around a b: the triangulation before the
/// move.
std::array<Tuple<3, 5>, 3> facets_at_ab(const Five_points& x) {
    return {{{&x.a, &x.b, &x.p, &x.q, &x.r}, {&x.a, &x.b, &x.q, &x.r, &x.p}, {&x.a, &x.b, &x.r, &x.p, &x.q}}};
}
std::array<Tuple<3, 4>, 3> cells_at_ab(const Five_points& x) {
    return {{{&x.a, &x.b, &x.q, &x.p}, {&x.a, &x.b, &x.r, &x.q}, {&x.a, &x.b, &x.p, &x.r}}};
}
/// The facet p q r between a and b: the other triangulation, of two cells.
Tuple<3, 5> facet_pqr(const Five_points& x) { return {&x.p, &x.q, &x.r, &x.b, &x.a}; }

/// The hull of the five points is the same in both, and convex by far.
bool three_cells_are_delaunay(const Five_points& x) {
    const auto holds = [](const auto& facet) { return empty_sphere_exact(facet).sign >= 0; };
    const auto positive = [](const auto& cell) { return orientation_exact(cell).sign > 0; };
    const auto facets = facets_at_ab(x);
    const auto cells = cells_at_ab(x);
    return std::all_of(facets.begin(), facets.end(), holds) && std::all_of(cells.begin(), cells.end(), positive);
}
bool two_cells_are_delaunay(const Five_points& x) {
    return empty_sphere_exact(facet_pqr(x)).sign >= 0 && orientation_exact({&x.p, &x.q, &x.r, &x.a}).sign > 0 &&
           orientation_exact({&x.q, &x.p, &x.r, &x.b}).sign > 0;
}

}  // namespace

Counterexample counterexample(double delta) {
    if (!(delta >= 0x1p-40 && delta <= 0.1)) throw Error(Error_code::usage, "delta must be from 2^-40 to 0.1");
    Counterexample r{};
    r.delta = delta;
    r.move = 0.7 * delta;
    const Five_points fixed = five_points(1.0 - delta, 1.0);
    const Five_points moved = five_points(1.0 - delta + r.move, 1.0 - r.move);
    const auto displacement = [&](const Point Five_points::*v) { return distance_upper<3>(fixed.*v, moved.*v); };
    r.displaced = std::max({displacement(&Five_points::a), displacement(&Five_points::b), displacement(&Five_points::p),
                            displacement(&Five_points::q), displacement(&Five_points::r)});
    r.paper = HUGE_VAL;
    r.exact = HUGE_VAL;
    r.theta = HUGE_VAL;
    r.certified.tolerance = HUGE_VAL;
    for (const auto& facet : facets_at_ab(fixed)) {
        r.paper = std::min(r.paper, paper_annulus(facet));
        r.theta = std::min(r.theta, theta(*facet[0], *facet[1], *facet[2], *facet[3], *facet[4]));
        r.exact = std::min(r.exact, empty_sphere_exact(facet, Cell_widths::always).tolerance);
        const Certificate_value v = evaluate_empty_sphere(facet, true, Cell_widths::always);
        if (v.tolerance < r.certified.tolerance) r.certified = v;
    }
    r.three_before = three_cells_are_delaunay(fixed);
    r.three_after = three_cells_are_delaunay(moved);
    r.two_after = two_cells_are_delaunay(moved);
    return r;
}

}  // namespace annulus::inline v1
