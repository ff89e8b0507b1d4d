// SPDX-License-Identifier: GPL-3.0-or-later
// filter_rounding_test.cpp for filter-each: what it writes down is rounded in the safe direction, to the last bit.

#include <relocation/filter_session.h>

#include <rapidcheck.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

REVEAL(Epsilon, &Filter_each<2>::epsilon_);
REVEAL(Each_examination, &Filter_each<2>::repair_);
REVEAL(Each_position, &Filter_each<2>::position_);
REVEAL(Lower, &Filter_each<2>::lower);
REVEAL(Each_passes, &Filter_each<2>::passes);

}  // namespace

TEST_CASE("filter-each: no tolerance is above what is left of a certificate's", "[relocation][rounding]") {
    REQUIRE(rc::check("where the difference rounds up", [](const Seed& seed) {
        Random random = seed.random();
        Session<Filter_each<2>> s(random);
        const auto cells = s.finite_cells();
        for (int i = 0; i < 20; ++i) {
            std::vector<Point> x = s.points;
            for (std::size_t v = 0; v < x.size(); ++v) {
                const double way =
                    s.filter.tolerance(static_cast<Index>(v)) * std::ldexp(0.1, -integer(random, 20, 45));
                x[v][0] += way * between(random, -1, 1);
                x[v][1] += way * between(random, -1, 1);
            }
            s[Each_position{}] = x;
            s[Epsilon{}].assign(x.size(), HUGE_VAL);
            s.filter.refresh(cells, s.report);
            const auto check = [&](Index v, double tolerance) {
                const Rational left = Rational(tolerance) - Rational(s[Epsilon{}][at(v)]);
                RC_ASSERT(left >= 0);
                RC_ASSERT(left * left >= exact_squared_distance(x[at(v)], s.filter.fixed_position(v)));
            };
            for (const auto& e : s[Each_examination{}].facets())
                if (e.kind != Facet_kind::border)
                    for (const Index v : e.point)
                        if (v != none) check(v, e.verdict.tolerance);
            for (const auto& e : s[Each_examination{}].cells())
                if (e.kind != Facet_kind::border)
                    for (const Index v : e.point) check(v, e.verdict.tolerance);
        }
    }));
}

TEST_CASE("filter-each: what passes is nearer to its fixed position than its tolerance", "[relocation][rounding]") {
    REQUIRE(rc::check("of tolerances of any magnitude", [](const Seed& seed) {
        Random random = seed.random();
        Session<Filter_each<2>> s(random);
        for (int i = 0; i < 500; ++i) {
            const auto v = static_cast<Index>(random() % s.points.size());
            const double tolerance = std::ldexp(1.0 + unit(random), integer(random, -30, 0));
            s[Epsilon{}][at(v)] = HUGE_VAL;
            s.call(Lower{}, v, tolerance);
            // As far as that, up to rounding, in some direction.
            const Point& f = s.filter.fixed_position(v);
            const double angle = between(random, 0.0, 6.3);
            Point& p = s[Each_position{}][at(v)];
            p = {f[0] + tolerance * std::cos(angle), f[1] + tolerance * std::sin(angle)};
            if (random() % 2 == 0) p[random() % 2] = f[random() % 2 == 0 ? 0 : 1];
            if (p != f && s.call(Each_passes{}, v))
                RC_ASSERT(exact_squared_distance(p, f) < Rational(tolerance) * Rational(tolerance));
        }
    }));
}
