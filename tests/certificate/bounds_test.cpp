// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of the filter beside the errors it makes, sought by climbing, and what the filter does with them.
//
// A tolerance alone says little about the bounds: what is taken off the determinant hides what is missing elsewhere
// (half a width is at most m, so 121 u m^4 of the determinant weighs more than 264 u m^3 of the roots). Here each is
// looked at by itself.

#include <support/arbitrary.h>
#include <support/stages.h>

#include <annulus/certificate/bounds.h>
#include <annulus/certificate/width_terms.h>

#include <gmpxx.h>
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Coordinates of three or four points, one after the other.
using Numbers = std::vector<double>;

/// How far the filter is off, in units of u times the power of m that its bound has.
struct Errors {
    double determinant = 0;  ///< of |determinant~ - determinant|
    double roots =
        0;  ///< of what the roots fall short by, in units of u m^3 less their own rounding; or relative, in u
};

Point point(const Numbers& x, std::size_t i) { return {x[2 * i], x[2 * i + 1]}; }

Vector_2<mpq_class> exact_difference(const Point& a, const Point& b) {
    return {mpq_class(mpq_class(a[0]) - mpq_class(b[0])), mpq_class(mpq_class(a[1]) - mpq_class(b[1]))};
}

double ratio(const mpq_class& x, const mpq_class& y) {
    const mpq_class r = x / y;
    return r.get_d();
}

/// sqrt(x) + sqrt(y) to a hundred bits and more, as a fraction.
mpq_class sum_of_roots(const mpq_class& x, const mpq_class& y) {
    mpf_class i(x, 2200), j(y, 2200);  // differences of squares of any magnitude in the range of the filter
    i = sqrt(i);
    j = sqrt(j);
    const mpf_class sum(i + j, 2200);
    return mpq_class(sum);
}

Errors triangle_errors(const Numbers& x) {
    const Point a = point(x, 0), b = point(x, 1), c = point(x, 2);
    const auto u = detail::difference(b, a), v = detail::difference(c, a);
    const double m = std::max(detail::magnitude(u), detail::magnitude(v));
    if (!(m > 0)) return {};
    const auto rounded = orientation_terms(u, v, detail::difference(c, b));
    const auto U = exact_difference(b, a), V = exact_difference(c, a), W = exact_difference(c, b);
    const mpq_class determinant = U.x * V.y - U.y * V.x;
    const mpq_class longest = std::max(
        {mpq_class(U.x * U.x + U.y * U.y), mpq_class(V.x * V.x + V.y * V.y), mpq_class(W.x * W.x + W.y * W.y)});
    const mpq_class unit = mpq_class(bounds::u) * mpq_class(m) * mpq_class(m);
    const mpq_class error = abs(mpq_class(rounded.determinant) - determinant);
    const mpq_class roots = sum_of_roots(longest, longest);
    const double computed = std::sqrt(rounded.inner) + std::sqrt(rounded.outer);
    const mpq_class missing = roots - mpq_class(computed);
    return {ratio(error, unit), ratio(missing, mpq_class(bounds::u) * roots)};
}

Errors bicell_errors(const Numbers& x) {
    const Point a = point(x, 0), b = point(x, 1), p = point(x, 2), q = point(x, 3);
    const auto fb = detail::difference(b, a), fp = detail::difference(p, a), fq = detail::difference(q, a);
    const auto fe = detail::difference(q, p);
    const double m =
        std::max({detail::magnitude(fb), detail::magnitude(fp), detail::magnitude(fq), detail::magnitude(fe)});
    if (!(m > 0)) return {};
    const auto rounded = annulus_terms(fb, fp, fq, fe);

    const auto B = exact_difference(b, a), P = exact_difference(p, a), Q = exact_difference(q, a);
    const mpq_class bb = B.x * B.x + B.y * B.y, pp = P.x * P.x + P.y * P.y, qq = Q.x * Q.x + Q.y * Q.y;
    const mpq_class bq = B.x * Q.y - B.y * Q.x, bp = B.x * P.y - B.y * P.x, pq = P.x * Q.y - P.y * Q.x;
    // The lifted determinant with a as the origin.
    const mpq_class determinant = pp * bq - bb * pq - qq * bp;
    const mpq_class D = bq - bp;
    // (q - p).(q + p - b), then the centre times 2 D and the vector from it to p.
    const mpq_class s = qq - pp - (Q.x - P.x) * B.x - (Q.y - P.y) * B.y;
    const mpq_class nx = D * B.x - s * B.y, ny = D * B.y + s * B.x;
    const mpq_class mx = nx - 2 * D * P.x, my = ny - 2 * D * P.y;
    const mpq_class roots = sum_of_roots(nx * nx + ny * ny, mx * mx + my * my);

    const mpq_class exact_m(m), unit(bounds::u);
    const mpq_class error = abs(mpq_class(rounded.determinant) - determinant);
    const mpq_class computed(std::sqrt(rounded.inner) + std::sqrt(rounded.outer));
    // Squares, roots and their sum: 3.5 u relative, which is in the tail.
    const mpq_class missing = roots - computed - mpq_class(3.5) * unit * computed;
    return {ratio(error, unit * exact_m * exact_m * exact_m * exact_m),
            ratio(missing, unit * exact_m * exact_m * exact_m)};
}

/// Climbs from x by changing a coordinate or two at a time, and returns the greatest value found. The coordinates stay
/// within `reach`.
template <class Value>
double climb(Numbers x, double reach, Random& random, int steps, Value value) {
    double best = value(x);
    for (int i = 0; i < steps; ++i) {
        Numbers y = x;
        for (std::uint64_t changes = 1 + random() % 2; changes > 0; --changes) {
            double& c = y[random() % y.size()];
            switch (random() % 4) {
                case 0: c = between(random, -reach, reach); break;
                case 1: c += std::ldexp(between(random, -1, 1), -integer(random, 1, 56)); break;
                case 2: c *= 1 + std::ldexp(between(random, -1, 1), -integer(random, 20, 53)); break;
                default: c = ulp_noise(random, c, 8); break;
            }
            c = std::max(-reach, std::min(reach, c));
        }
        const double v = value(y);
        if (v >= best) {
            best = v;
            x = y;
        }
    }
    return best;
}

Numbers start(std::size_t n, Random& random) {
    Numbers x(n);
    for (double& c : x) c = between(random, -0.5, 0.5);
    return x;
}

/// Differences just above 1 in magnitude: there a rounding error is largest beside the number.
Numbers just_above_one(std::size_t n, Random& random) {
    const auto near = [&random](double c) { return c * (1 + std::ldexp(unit(random), -integer(random, 1, 50))); };
    Numbers x(n);
    if (random() % 2 == 0) {
        for (double& c : x) c = near(random() % 2 == 0 ? 1 : -1);
        for (std::size_t i = 0; i < 2; ++i) x[i] = std::ldexp(between(random, -1, 1), -integer(random, 1, 53));
    } else {
        for (double& c : x) c = near(random() % 2 == 0 ? 0.5 : -0.5);
    }
    return x;
}

/// Coordinates of very different magnitudes, in the range of the filter as a whole.
Numbers spread(std::size_t n, Random& random) {
    Numbers x(n);
    const int exponent = integer(random, -118, 118), depth = integer(random, 0, 1) * 400;
    for (double& c : x) c = std::ldexp(between(random, -1, 1), exponent - integer(random, 0, depth));
    x[random() % n] = std::ldexp(1.0, exponent);
    return x;
}

std::string text(const Numbers& x) {
    std::string s = "{";
    for (const double c : x) s += as_code(c) + ", ";
    return s + "}";
}

}  // namespace

TEST_CASE("the filter is never off by more than its bounds", "[certificate]") {
    REQUIRE(rc::check("on coordinates of one magnitude and of many", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 30; ++i) {
            const Numbers x = i % 2 == 0 ? start(6, random) : spread(6, random);
            const Errors e = triangle_errors(x);
            if (!(e.determinant <= bounds::orientation_2 && e.roots <= bounds::tail)) RC_FAIL(text(x));
            const Numbers y = i % 2 == 0 ? start(8, random) : spread(8, random);
            const Errors f = bicell_errors(y);
            if (!(f.determinant <= bounds::annulus_2_incircle && f.roots <= bounds::annulus_2_norms)) RC_FAIL(text(y));
        }
    }));
}

TEST_CASE("the filter is never off by more than its bounds, sought by climbing", "[certificate]") {
    Random random(Catch::rngSeed());
    std::array<double, 4> most{};
    const auto climb_to = [&](double& top, std::size_t n, int steps, const auto& value) {
        for (int i = 0; i < 2; ++i) {
            top = std::max(top, climb(start(n, random), 0.5, random, steps, value));
            top = std::max(top, climb(just_above_one(n, random), 1.5, random, steps, value));
        }
    };
    climb_to(most[0], 6, 8000, [](const Numbers& x) { return triangle_errors(x).determinant; });
    climb_to(most[1], 6, 1000, [](const Numbers& x) { return triangle_errors(x).roots; });
    climb_to(most[2], 8, 6000, [](const Numbers& x) { return bicell_errors(x).determinant; });
    climb_to(most[3], 8, 6000, [](const Numbers& x) { return bicell_errors(x).roots; });
    std::printf(
        "greatest errors found, in u (bound): orientation %.2f (%g), its roots, relative %.2f (%g), empty circle %.2f "
        "(%g), its roots %.2f (%g)\n",
        most[0], bounds::orientation_2, most[1], bounds::tail, most[2], bounds::annulus_2_incircle, most[3],
        bounds::annulus_2_norms);
    CHECK(most[0] <= bounds::orientation_2);
    CHECK(most[1] <= bounds::tail);
    CHECK(most[2] <= bounds::annulus_2_incircle);
    CHECK(most[3] <= bounds::annulus_2_norms);
    // The climb gets somewhere.
    CHECK(most[0] > 2);
    CHECK(most[2] > 4);
    CHECK(most[3] > 4);
}

TEST_CASE("an orientation off by 8 u m^2", "[certificate]") {
    // Differences just above 1, found by climbing: a bound proved for m = 1 is not one for every m.
    const Numbers x{0x1.000003d0f177dp-1, 0x1.0000000871f71p-1,  -0x1.fffffff7bd8a4p-2,
                    0x1.800006170d57ap+0, -0x1.fffffb649e77cp-2, -0x1.fffffffff396cp-2};
    CHECK(triangle_errors(x).determinant > 7.9999);
    CHECK(triangle_errors(x).determinant <= bounds::orientation_2);
}

TEST_CASE("the bound of the norms is made of those of the two vectors", "[certificate]") {
    CHECK(bounds::annulus_2_norms >= std::sqrt(2.0) * (bounds::annulus_2_inner + bounds::annulus_2_outer));
    CHECK(bounds::u == std::numeric_limits<double>::epsilon() / 2);
}

TEST_CASE("rounded terms are accepted with their errors taken off, or not at all", "[certificate]") {
    Verdict v;
    const auto answers = [&v](double determinant, double root, double det_error, double norm_error,
                              bool certified = true) {
        v = {};
        return detail::accept({determinant, root * root, root * root}, det_error, norm_error, certified, v);
    };
    const double share = bounds::filter_slack;
    SECTION("without errors it is the quotient less the tail") {
        REQUIRE(answers(3, 1, 0, 0));
        CHECK(v.sign == 1);
        CHECK(v.stage == Stage::filter);
        CHECK(v.tolerance < 1.5);
        CHECK(v.tolerance >= 1.5 * (1 - 20 * bounds::u));
    }
    SECTION("both errors are taken off") {
        const double e = 0x1p-20;
        REQUIRE(answers(1, 1, e, 0));
        CHECK(v.tolerance <= 0.5 * (1 - e));
        CHECK(v.tolerance >= 0.5 * (1 - e) * (1 - 20 * bounds::u));
        REQUIRE(answers(1, 1, 0, e));
        CHECK(v.tolerance <= 1 / (2 + e));
        CHECK(v.tolerance >= 1 / (2 + e) * (1 - 20 * bounds::u));
        REQUIRE(answers(1, 1, e, e));
        CHECK(v.tolerance <= (1 - e) / (2 + e));
        REQUIRE(answers(1, 1, e, e, false));
        CHECK(v.tolerance == 0.5);
    }
    SECTION("each error is at most the stated share") {
        CHECK(answers(1, 1, 0.99 * share, 0));
        CHECK(!answers(1, 1, share, 0));
        CHECK(!answers(1, 1, share, 0, false));
        CHECK(answers(1, 1, 0, 2 * 0.99 * share));
        CHECK(!answers(1, 1, 0, 2 * share));
        CHECK(answers(1, 1, 0, 2 * share, false));
    }
    SECTION("a sign needs more than the error") {
        CHECK(!answers(-1, 1, 1, 0));
        CHECK(!answers(0, 1, 0, 0));
        CHECK(!answers(0, 1, 1, 0));
        REQUIRE(answers(-1, 1, 0.99, 0));
        CHECK(v.sign == -1);
        CHECK(v.tolerance == 0.0);
    }
    SECTION("what is not a number is not an answer") {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        CHECK(!answers(nan, 1, 0, 0));
        CHECK(!answers(1, nan, 0, 0));
        CHECK(!answers(1, 1, nan, 0));
        CHECK(!answers(1, 1, 0, nan));
    }
}
