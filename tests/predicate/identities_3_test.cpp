// SPDX-License-Identifier: GPL-3.0-or-later
// Transformations that must not change half widths in 3D: the order of the points, the side from which a bi-cell is
// seen, powers of two, and exact translations.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages_3.h>

#include <algorithm>
#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <class Map>
Bicell_3 mapped(const Bicell_3& c, Map map) {
    return {map(c.a), map(c.b), map(c.c), map(c.p), map(c.q)};
}

Point_3 scaled(Point_3 p, int exponent) {
    for (double& c : p) c = std::ldexp(c, exponent);
    return p;
}

bool is_of_usual_magnitude(const Bicell_3& c) {
    for (const Point_3* p : c.tuple())
        for (const double x : *p)
            if (x != 0.0 && (std::fabs(x) < 0x1p-60 || std::fabs(x) > 0x1p60)) return false;
    return true;
}

}  // namespace

TEST_CASE("the half widths of a bi-cell of space do not depend on how it is named", "[certificate][space]") {
    REQUIRE(for_all("on bi-cells of every family", [](const Seed& seed) {
        for_each_delaunay_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            for (const Cell_widths cells : all_cells) {
                const Certificate_value v = empty_sphere_exact(c.tuple(), cells);
                for (const Bicell_3& other : {c.turned(), c.rotated(), c.rotated().rotated(), c.turned().rotated()}) {
                    const Certificate_value w = empty_sphere_exact(other.tuple(), cells);
                    HOLDS(v.sign == w.sign && v.tolerance == w.tolerance, c);
                    HOLDS((v.wrong_side == 0) == (w.wrong_side == 0), c);
                    const Certificate_value l = evaluate_empty_sphere(other.tuple(), true, cells);
                    HOLDS(l.sign == v.sign && l.tolerance <= v.tolerance, c);
                }
            }
            const Annuli a = annuli_exact(c.tuple()), turned = annuli_exact(c.turned().tuple()),
                         rotated = annuli_exact(c.rotated().tuple());
            // b, a, c, q, p: ab | c.. stays, ca and bc are exchanged. b, c, a: each moves to the place before it.
            HOLDS(
                a.half_width[abc_pq] == turned.half_width[abc_pq] && a.half_width[ab_cpq] == turned.half_width[ab_cpq],
                c);
            HOLDS(
                a.half_width[ca_bpq] == turned.half_width[bc_apq] && a.half_width[bc_apq] == turned.half_width[ca_bpq],
                c);
            HOLDS(a.half_width[abc_pq] == rotated.half_width[abc_pq] &&
                      a.half_width[bc_apq] == rotated.half_width[ab_cpq],
                  c);
            HOLDS(a.half_width[ab_cpq] == rotated.half_width[ca_bpq] &&
                      a.half_width[ca_bpq] == rotated.half_width[bc_apq],
                  c);
        });
    }));
}

TEST_CASE("the width of a tetrahedron does not depend on the order of its vertices", "[certificate][space]") {
    REQUIRE(for_all("on tetrahedra of every family", [](const Seed& seed) {
        for_each_tetrahedron(seed.random(), 1, [](const Tetrahedron& t) {
            const std::array<const Point_3*, 4> x = t.tuple();
            std::array<std::size_t, 4> order{0, 1, 2, 3};
            const Certificate_value v = orientation_exact(t.tuple());
            double width = v.tolerance;
            if (v.sign < 0) width = orientation_exact({x[1], x[0], x[2], x[3]}).tolerance;
            do {
                int inversions = 0;
                for (std::size_t i = 0; i < 4; ++i)
                    for (std::size_t j = 0; j < i; ++j) inversions += order[j] > order[i];
                const Certificate_value w = orientation_exact({x[order[0]], x[order[1]], x[order[2]], x[order[3]]});
                HOLDS(w.sign == (inversions % 2 == 0 ? v.sign : -v.sign), t);
                HOLDS(w.tolerance == (w.sign > 0 ? width : 0.0), t);
            } while (std::next_permutation(order.begin(), order.end()));
        });
    }));
}

TEST_CASE("half widths scale by powers of two and do not see exact translations", "[certificate][space]") {
    REQUIRE(for_all("on bi-cells of usual magnitudes", [](const Seed& seed) {
        Random random = seed.random();
        for_each_delaunay_bicell_3(seed.random(), 1, [&random](const Bicell_3& c) {
            if (!is_of_usual_magnitude(c)) return;
            const int exponent = integer(random, -20, 20);
            const Bicell_3 s = mapped(c, [exponent](const Point_3& p) { return scaled(p, exponent); });
            const Answers one = answers_of(c, Cell_widths::always), other = answers_of(s, Cell_widths::always);
            const auto corresponds = [exponent](const Certificate_value& v, const Certificate_value& w) {
                return v.sign == w.sign && std::ldexp(v.tolerance, exponent) == w.tolerance &&
                       v.wrong_side == w.wrong_side;
            };
            HOLDS(corresponds(one.exact, other.exact), c);
            HOLDS(!one.filter || !other.filter || corresponds(*one.filter, *other.filter), c);
            HOLDS(!one.interval || !other.interval || corresponds(*one.interval, *other.interval), c);
        });
        for (int i = 0; i < 10; ++i) {
            const Bicell_3 c = delaunay_bicell(Family_3::grid, random);
            const Point_3 by{static_cast<double>(integer(random, -999, 999)), 0x1p40, -0x1p30};
            const Bicell_3 t = mapped(c, [&by](Point_3 p) {
                for (std::size_t k = 0; k < 3; ++k) p[k] += by[k];
                return p;
            });
            HOLDS(empty_sphere_exact(c.tuple()).tolerance == empty_sphere_exact(t.tuple()).tolerance, c);
            HOLDS(evaluate_empty_sphere(c.tuple()).tolerance == evaluate_empty_sphere(t.tuple()).tolerance, c);
        }
    }));
}
