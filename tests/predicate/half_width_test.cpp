// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/filtered.h>
#include <annulus/predicate/half_width.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/repeats.h>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Compares both ends with the truth, in rational numbers; `exact` is the result of the exact stage.
template <class Truth>
void check_ends(const Half_width& h, const Half_width& exact, const Truth& truth) {
    CHECK(exact.stage == Stage::exact);
    if (truth.sign() <= 0) {
        CHECK(h.lower == 0);
        CHECK(h.upper == 0);
        return;
    }
    CHECK(h.upper > 0);
    CHECK(truth.is_at_least(h.lower));
    CHECK(truth.is_at_least(exact.lower));
    if (exact.upper < HUGE_VAL) CHECK_FALSE(truth.is_at_least(exact.upper));
    if (h.upper < HUGE_VAL) CHECK((h.upper == exact.upper || !truth.is_at_least(h.upper)));
    CHECK(h.lower <= exact.lower);
    CHECK(h.upper >= exact.lower);
    if (h.stage == Stage::interval) CHECK(h.upper <= h.lower * (1 + 0x1p-9));
    for (const double y : {h.lower, h.upper, exact.lower, exact.upper, std::nextafter(exact.lower, 0.0)}) {
        if (!(y < HUGE_VAL)) continue;
        CHECK(exact.is_below(y) == !truth.is_at_least(y));
        CHECK(exact.is_below(y) != exact.is_not_below(y));
        if (h.is_below(y)) CHECK_FALSE(truth.is_at_least(y));
        if (h.is_not_below(y)) CHECK(truth.is_at_least(y));
    }
}

const int tries = repeats(60);

}  // namespace

TEST_CASE("half widths are enclosed: triangles and empty circles", "[certificate][half_width]") {
    Random random(3);
    for (const Bicell_family family : all_bicell_families)
        for (int i = 0; i < tries; ++i) {
            const Bicell c = delaunay_bicell(family, random);
            INFO(as_code(c));
            const std::array<Tuple<2, 4>, 1> x{c.tuple()};
            std::array<Bicell_half_widths, 1> out;
            enclose(x, out);
            check_ends(out[0].least, enclose_exactly(x[0]).least, Bicell_truth(c));
            CHECK(out[0].least.lower == out[0].standard.lower);
            const Triangle t{c.a, c.b, c.q};
            const std::array<Tuple<2, 3>, 1> y{t.tuple()};
            std::array<Half_width, 1> h;
            enclose(y, Width::least, h);
            check_ends(h[0], enclose_exactly(y[0], Width::least), Triangle_truth(t));
        }
}

TEST_CASE("half widths are enclosed: tetrahedra and empty spheres", "[certificate][half_width]") {
    Random random(4);
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < tries; ++i) {
            const Bicell_3 c = delaunay_bicell(family, random);
            INFO(as_code(c));
            const std::array<Tuple<3, 5>, 1> x{c.tuple()};
            std::array<Bicell_half_widths, 1> out;
            enclose(x, out);
            const Bicell_half_widths exact = enclose_exactly(x[0]);
            check_ends(out[0].least, exact.least, Bicell_3_truth(c, false));
            check_ends(out[0].standard, exact.standard, Annulus_truth(c, 0));
            if (out[0].standard_is_least) CHECK(exact.standard.lower == exact.least.lower);
            const Tetrahedron t = c.cell_q();
            const std::array<Tuple<3, 4>, 1> y{t.tuple()};
            std::array<Half_width, 1> h;
            enclose(y, Width::least, h);
            check_ends(h[0], enclose_exactly(y[0], Width::least), Tetrahedron_truth(t));
        }
}

TEST_CASE("the paper's slabs", "[certificate][half_width]") {
    // Altitude 3 over a facet; lines at distance 5.
    const Coordinates<3> a{0, 0, 0}, b{4, 0, 0}, c{0, 7, 0}, e{2, 2, 3}, f{1, 1, 5}, g{1, 9, 5};
    CHECK(enclose_exactly(Tuple<3, 4>{&a, &b, &c, &e}, Width::slab).lower == 1.5);
    CHECK(enclose_exactly(Tuple<3, 4>{&b, &a, &c, &e}, Width::slab).upper == 0);  // negative
    CHECK(enclose_exactly(Tuple<3, 4>{&a, &b, &f, &g}, Width::ridge).lower == 2.5);
    CHECK(enclose_exactly(Tuple<3, 4>{&b, &a, &f, &g}, Width::ridge).lower == 2.5);
    const Coordinates<2> p{0, 0}, q{8, 0}, r{9, 3};
    CHECK(enclose_exactly(Tuple<2, 3>{&p, &q, &r}, Width::slab).lower == 1.5);
    CHECK(enclose_exactly(Tuple<2, 3>{&p, &q, &r}, Width::ridge).lower == 1.5);
    Random random(5);
    for (const Family_3 family : all_families_3)
        for (int i = 0; i < tries; ++i) {
            const Tetrahedron t = delaunay_bicell(family, random).cell_q();
            const std::array<Tuple<3, 4>, 1> x{t.tuple()};
            for (const Width which : {Width::slab, Width::ridge}) {
                std::array<Half_width, 1> h;
                enclose(x, which, h);
                const Half_width exact = enclose_exactly(x[0], which);
                INFO(as_code(t));
                CHECK(h[0].lower <= exact.lower);
                CHECK(h[0].upper >= exact.lower);
                // No slab is narrower than the narrowest.
                CHECK(exact.lower >= enclose_exactly(x[0], Width::least).lower);
                const double plain = which == Width::slab ? paper_slab(x[0]) : paper_ridge(x[0]);
                if (family == Family_3::uniform) CHECK(plain == Approx(exact.lower).epsilon(1e-6));
            }
        }
}
