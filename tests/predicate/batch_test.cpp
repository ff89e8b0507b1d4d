// SPDX-License-Identifier: GPL-3.0-or-later
// A batch returns the results of single calls, bit for bit, and each precision keeps its guarantee.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/oracle.h>
#include <support/oracle_3.h>
#include <support/stages_3.h>

#include <annulus/predicate/filtered.h>

#include <cfenv>
#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

bool same(const Certificate_value& l, const Certificate_value& r) {
    return l.tolerance == r.tolerance && l.sign == r.sign && l.stage == r.stage && l.wrong_side == r.wrong_side;
}

/// The batch against `single`, for every length from 0 to that of x, so that every remainder of lanes is met.
template <class Case, class T, class Single, class... More>
void check(const std::vector<Case>& x, const std::vector<T>& tuples, Tolerance_precision mode, Single single,
           More... more) {
    std::vector<Certificate_value> expected;
    for (const T& t : tuples) expected.push_back(single(t));
    for (std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{2}, std::size_t{3}, tuples.size()}) {
        if (size > tuples.size()) continue;
        std::vector<Certificate_value> out(size, Certificate_value{-1.0, 7, Stage::exact, 255});
        const Stage_counts counts = evaluate(std::span<const T>(tuples.data(), size), mode, out, more...);
        Stage_counts counted;
        for (std::size_t i = 0; i < size; ++i) {
            counted.count(out[i].stage);
            HOLDS(same(out[i], expected[i]), x[i]);
        }
        RC_ASSERT(counts == counted);
        RC_ASSERT(std::fegetround() == FE_TONEAREST);
    }
}

/// The certificate value of a single call with a precision.
template <class T, class... More>
Certificate_value one(const T& x, Tolerance_precision mode, More... more) {
    constexpr bool is_orientation = std::is_same_v<T, Tuple<2, 3>> || std::is_same_v<T, Tuple<3, 4>>;
    Certificate_value v, e;
    if constexpr (is_orientation) {
        v = evaluate_orientation(x, mode != Tolerance_precision::approximate);
        e = orientation_exact(x);
    } else {
        v = evaluate_empty_sphere(x, mode != Tolerance_precision::approximate, more...);
        e = empty_sphere_exact(x, more...);
    }
    return mode == Tolerance_precision::correctly_rounded && v.sign > 0 ? e : v;
}

template <class Case, class... More>
void check_modes(const std::vector<Case>& x, More... more) {
    std::vector<decltype(x[0].tuple())> tuples;
    for (const Case& c : x) tuples.push_back(c.tuple());
    for (const Tolerance_precision mode :
         {Tolerance_precision::approximate, Tolerance_precision::lower_bound, Tolerance_precision::correctly_rounded})
        check(
            x, tuples, mode, [&](const auto& t) { return one(t, mode, more...); }, more...);
}

}  // namespace

TEST_CASE("a batch is a loop of single calls, bit for bit", "[certificate][space]") {
    REQUIRE(for_all("in the plane", [](const Seed& seed) {
        std::vector<Triangle> triangles;
        std::vector<Bicell> bicells;
        for_each_triangle(seed.random(), 2, [&](const Triangle& t) { triangles.push_back(t); });
        for_each_bicell(seed.random(), 2, [&](const Bicell& c) { bicells.push_back(c); });
        check_modes(triangles);
        check_modes(bicells);
    }));
    REQUIRE(for_all("in space", [](const Seed& seed) {
        std::vector<Tetrahedron> tetrahedra;
        std::vector<Bicell_3> bicells;
        for_each_tetrahedron(seed.random(), 1, [&](const Tetrahedron& t) { tetrahedra.push_back(t); });
        for_each_bicell_3(seed.random(), 1, [&](const Bicell_3& c) { bicells.push_back(c); });
        check_modes(tetrahedra);
        for (const Cell_widths cells : all_cells) check_modes(bicells, cells);
    }));
}

TEST_CASE("tight is the largest double that is not above the truth", "[certificate]") {
    REQUIRE(for_all("in the plane", [](const Seed& seed) {
        for_each_triangle(seed.random(), 3, [](const Triangle& t) {
            const Triangle_truth truth(t);
            const double y = orientation_exact(t.tuple()).tolerance;
            HOLDS(truth.sign() <= 0 || (truth.is_at_least(y) && !truth.is_at_least(std::nextafter(y, HUGE_VAL))), t);
        });
        for_each_delaunay_bicell(seed.random(), 3, [](const Bicell& c) {
            const Bicell_truth truth(c);
            const double y = empty_sphere_exact(c.tuple()).tolerance;
            HOLDS(truth.sign() <= 0 || (truth.is_at_least(y) && !truth.is_at_least(std::nextafter(y, HUGE_VAL))), c);
        });
    }));
    // Half widths that are doubles: the tie test has to decide.
    CHECK(orientation_exact(Triangle{{-1, 0}, {1, 0}, {0, 0.5}}.tuple()).tolerance == 0.25);
    CHECK(empty_sphere_exact(Bicell{{0, -1}, {0, 1}, {3, 0}, {-3, 0}}.tuple()).tolerance == 1.0);
    CHECK(empty_sphere_exact(Bicell{{0, -0x1p-1074}, {0, 0x1p-1074}, {0x3p-1074, 0}, {-0x3p-1074, 0}}.tuple())
              .tolerance == 0x1p-1074);
}

TEST_CASE(
    "the sign tolerance is the least half width of annuli and cells, that of a vertex the least of its certificates",
    "[certificate][space]") {
    REQUIRE(for_all("of bi-cells in the plane and in space", [](const Seed& seed) {
        for_each_delaunay_bicell(seed.random(), 1, [](const Bicell& c) {
            const Certificate_value sign = evaluate_sign_tolerance(c.tuple(), Tolerance_precision::correctly_rounded);
            const double cells = std::min(orientation_exact({&c.a, &c.b, &c.q}).tolerance,
                                          orientation_exact({&c.b, &c.a, &c.p}).tolerance);
            HOLDS(sign.tolerance == std::min(empty_sphere_exact(c.tuple()).tolerance, cells), c);
            HOLDS(evaluate_sign_tolerance(c.tuple()).tolerance <= sign.tolerance, c);
            HOLDS(evaluate_sign_tolerance(c.tuple()).sign == sign.sign, c);
        });
        for_each_delaunay_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            const Certificate_value sign = evaluate_sign_tolerance(c.tuple(), Tolerance_precision::correctly_rounded);
            HOLDS(sign.tolerance == empty_sphere_exact(c.tuple(), Cell_widths::always).tolerance, c);
            HOLDS(evaluate_sign_tolerance(c.tuple()).tolerance <= sign.tolerance, c);
        });
    }));
    std::vector<double> tolerance(5, HUGE_VAL);
    const std::vector<std::array<Index, 3>> triangles{{0, 1, 2}, {1, 2, 3}};
    const std::vector<Certificate_value> verdicts{{0.5, 1}, {0.25, 1}};
    lower_to_certificates<3>(triangles, verdicts, tolerance);
    CHECK(tolerance == std::vector<double>{0.5, 0.25, 0.25, 0.25, HUGE_VAL});
}
