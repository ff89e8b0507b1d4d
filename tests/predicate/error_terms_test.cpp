// SPDX-License-Identifier: GPL-3.0-or-later
// Every error term of the filter is needed and present. A sign without its term is wrong next to a zero of the
// determinant, which rational numbers find by bisection. No tolerance can show a missing term of the norms, because the
// error subtracted from the determinant hides it (bounds_test.cpp): these terms are compared with the quotient in the
// proofs.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/stages_3.h>

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/circumcircle_2.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Rational = mpq_class;

/// d coordinates of each of n points.
template <int d, std::size_t n>
using Points_of = std::array<Coordinates<d>, n>;

template <int d, std::size_t n>
Points_of<d, n> some_points(Random& random) {
    Points_of<d, n> x;
    for (auto& p : x)
        for (double& c : p) c = between(random, -1, 1);
    return x;
}

/// Random points moved along one coordinate to where sign(x) changes, exactly up to the last bit; nothing when it
/// does not.
template <int d, std::size_t n, class Sign>
std::optional<Points_of<d, n>> at_a_change(Random& random, Sign sign) {
    auto x = some_points<d, n>(random);
    double& c = x[random() % n][random() % static_cast<std::size_t>(d)];
    const auto sign_at = [&](double value) {
        c = value;
        return sign(x) > 0;
    };
    double low = -1.0, high = 1.0;
    const bool below = sign_at(low);
    if (sign_at(high) == below) return {};
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) break;
        (sign_at(middle) == below ? low : high) = middle;
    }
    c = random() % 2 == 0 ? low : high;
    return x;
}

/// check(x) for points at changes of the sign, `each` times.
template <int d, std::size_t n, class Sign, class Check>
void at_changes(const Seed& seed, int each, Sign sign, Check check) {
    Random random = seed.random();
    for (int i = 0; i < each; ++i)
        if (const auto x = at_a_change<d, n>(random, sign)) check(*x);
}

Bicell bicell_of(const Points_of<2, 4>& x) { return {x[0], x[1], x[2], x[3]}; }
Triangle triangle_of(const Points_of<2, 3>& x) { return {x[0], x[1], x[2]}; }
Tetrahedron tetrahedron_of(const Points_of<3, 4>& x) { return {x[0], x[1], x[2], x[3]}; }
Bicell_3 bicell_of(const Points_of<3, 5>& x) { return {x[0], x[1], x[2], x[3], x[4]}; }

int sign_of(const Triangle& t) { return exact_orientation(t.a, t.b, t.c); }
int sign_of(const Tetrahedron& t) { return exact_orientation(t.a, t.b, t.c, t.d); }
int sign_of(const Bicell& c) { return exact_empty_circle(c.a, c.b, c.q, c.p); }
int sign_of(const Bicell_3& c) { return exact_empty_sphere(c.a, c.b, c.c, c.q, c.p); }

/// Sums of lambda over the sides p q, c p q, b p q, a p q: signed volumes.
std::array<Rational, partitions_3> sides(const Bicell_3& x) {
    const auto volume = [&x](const Point_3& u, const Point_3& v, const Point_3& w) {
        std::array<std::array<Rational, 3>, 3> m;
        for (std::size_t k = 0; k < 3; ++k) {
            m[0][k] = Rational(u[k]) - Rational(x.a[k]);
            m[1][k] = Rational(v[k]) - Rational(x.a[k]);
            m[2][k] = Rational(w[k]) - Rational(x.a[k]);
        }
        return Rational(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                        m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                        m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
    };
    const Rational b = volume(x.c, x.p, x.q), c = -volume(x.b, x.p, x.q),
                   pq = volume(x.b, x.c, x.q) - volume(x.b, x.c, x.p);
    return {pq, pq + c, pq + b, Rational(-b - c)};
}

template <class Case>
void check_sign(const Case& x, const Answers& answers) {
    const int truth = sign_of(x);
    HOLDS(!answers.filter || answers.filter->sign == truth, x);
    HOLDS(!answers.floating || answers.floating->sign == truth, x);
}

Rational to_the(double m, int degree) {
    Rational r(1);
    for (int i = 0; i < degree; ++i) r *= Rational(m);
    return r;
}
/// constant u m^degree
Rational term(double constant, double m, int degree) {
    return Rational(constant) * Rational(bounds::u) * to_the(m, degree);
}

/// tolerance <= (determinant - det_error) / (roots + norm_error)
bool is_below(double tolerance, double determinant, const Rational& det_error, double roots,
              const Rational& norm_error) {
    return Rational(tolerance) * (Rational(roots) + norm_error) <= Rational(determinant) - det_error;
}

}  // namespace

TEST_CASE("the filter claims no sign that is within its error", "[certificate][space]") {
    REQUIRE(for_all("of triangles", [](const Seed& seed) {
        at_changes<2, 3>(
            seed, 8, [](const auto& x) { return sign_of(triangle_of(x)); },
            [](const auto& x) { check_sign(triangle_of(x), answers_of(triangle_of(x))); });
    }));
    REQUIRE(for_all("of bi-cells", [](const Seed& seed) {
        at_changes<2, 4>(
            seed, 8, [](const auto& x) { return sign_of(bicell_of(x)); },
            [](const auto& x) { check_sign(bicell_of(x), answers_of(bicell_of(x))); });
    }));
    REQUIRE(for_all("of tetrahedra", [](const Seed& seed) {
        at_changes<3, 4>(
            seed, 8, [](const auto& x) { return sign_of(tetrahedron_of(x)); },
            [](const auto& x) { check_sign(tetrahedron_of(x), answers_of(tetrahedron_of(x))); });
    }));
    REQUIRE(for_all("of bi-cells in space", [](const Seed& seed) {
        at_changes<3, 5>(
            seed, 8, [](const auto& x) { return sign_of(bicell_of(x)); },
            [](const auto& x) { check_sign(bicell_of(x), answers_of(bicell_of(x), Cell_widths::never)); });
    }));
    REQUIRE(for_all("of a circle that is evaluated many times", [](const Seed& seed) {
        at_changes<2, 3>(
            seed, 8, [](const auto& x) { return sign_of(triangle_of(x)); },
            [](const auto& x) {
                HOLDS(!Circumcircle_2(x[0], x[1], x[2]).positive() || sign_of(triangle_of(x)) > 0, triangle_of(x));
            });
        at_changes<2, 4>(
            seed, 8, [](const auto& x) { return sign_of(bicell_of(x)); },
            [](const auto& x) {
                const Circumcircle_2 circle(x[0], x[1], x[3]);
                HOLDS(!circle.positive() || !circle.excludes(x[2]) || sign_of(bicell_of(x)) > 0, bicell_of(x));
            });
    }));
}

TEST_CASE("the filter calls no partition right that is within its error of its wrong side", "[certificate][space]") {
    for (std::size_t k = 1; k < partitions_3; ++k)
        REQUIRE(for_all("partition " + std::to_string(k), [k](const Seed& seed) {
            at_changes<3, 5>(
                seed, 8, [k](const auto& x) { return sgn(sides(bicell_of(x))[k]); },
                [k](const auto& x) {
                    const Bicell_3 c = bicell_of(x);
                    const Answers answers = answers_of(c, Cell_widths::where_needed);
                    if (!answers.filter || sgn(sides(c)[k]) > 0) return;
                    HOLDS((answers.filter->wrong_side & (1U << k)) != 0, c);
                });
        }));
}

TEST_CASE("a tolerance of the filter is what is left after the errors of determinant and norms",
          "[certificate][space]") {
    REQUIRE(for_all("in the plane", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 10; ++i) {
            const Triangle t = triangle_of(some_points<2, 3>(random));
            const auto u = detail::difference(t.b, t.a), v = detail::difference(t.c, t.a);
            const double m = std::max(detail::magnitude(u), detail::magnitude(v));
            const auto s = orientation_terms(u, v, detail::difference(t.c, t.b));
            if (const auto a = answers_of(t).filter; a && a->sign > 0)
                HOLDS(is_below(a->tolerance, s.determinant, term(bounds::orientation_2, m, 2), 2.0 * std::sqrt(s.inner),
                               0),
                      t);

            const Bicell c = bicell_of(some_points<2, 4>(random));
            const auto b = detail::difference(c.b, c.a), p = detail::difference(c.p, c.a);
            const auto q = detail::difference(c.q, c.a), e = detail::difference(c.q, c.p);
            const double M =
                std::max({detail::magnitude(b), detail::magnitude(p), detail::magnitude(q), detail::magnitude(e)});
            const auto w = annulus_terms(b, p, q, e);
            if (const auto a = answers_of(c).filter; a && a->sign > 0)
                HOLDS(is_below(a->tolerance, w.determinant, term(bounds::annulus_2_incircle, M, 4),
                               std::sqrt(w.inner) + std::sqrt(w.outer), term(bounds::annulus_2_norms, M, 3)),
                      c);
        }
    }));
    REQUIRE(for_all("in space, annuli and cells", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 10; ++i) {
            const Bicell_3 c = bicell_of(some_points<3, 5>(random));
            const auto b = detail::difference(c.b, c.a), f = detail::difference(c.c, c.a);
            const auto p = detail::difference(c.p, c.a), q = detail::difference(c.q, c.a);
            const double m =
                std::max({detail::magnitude(b), detail::magnitude(f), detail::magnitude(p), detail::magnitude(q)});
            const auto is_cell_below = [](double tolerance, const Width_terms<double>& s, double largest) {
                return is_below(tolerance, s.determinant, term(bounds::orientation_3, largest, 3),
                                2.0 * std::sqrt(s.inner), term(bounds::orientation_3_norms, largest, 2));
            };
            const Tetrahedron t = c.cell_q();
            if (const auto a = answers_of(t).filter; a && a->sign > 0)
                HOLDS(is_cell_below(a->tolerance, orientation_terms(b, f, q),
                                    std::max({detail::magnitude(b), detail::magnitude(f), detail::magnitude(q)})),
                      t);
            const auto a = answers_of(c, Cell_widths::always).filter;
            if (!a || a->sign <= 0) continue;
            const auto s = annulus_terms(b, f, p, q);
            HOLDS(is_cell_below(a->tolerance, cell_p_terms(s), m) && is_cell_below(a->tolerance, cell_q_terms(s), m),
                  c);
            for (std::size_t k = 0; k < partitions_3; ++k) {
                HOLDS(is_below(a->tolerance, s.determinant, term(bounds::annulus_3_insphere, m, 5),
                               std::sqrt(s.inner[k]) + std::sqrt(s.outer[k]), term(bounds::annulus_3_norms, m, 4)),
                      c);
                // The same for the sides: a partition is on the right side only if its value is above the error.
                const bool forward = (a->wrong_side & (1U << k)) == 0;
                HOLDS(k == 0 || !forward || Rational(s.side[k]) > term(bounds::annulus_3_side, m, 3), c);
            }
        }
    }));
}
