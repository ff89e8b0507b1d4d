// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The errors of the filter for given coordinates, in the units of its bounds (annulus/predicate/bounds.h), and the
// slack of its tolerance. Rational numbers, so that the same coordinates give the same double everywhere. Each kind can
// be maximised by climbing.

#include <support/generators_3.h>
#include <support/oracle_3.h>
#include <support/stages_3.h>

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/width_terms.h>
#include <annulus/predicate/width_terms_3.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace annulus::testing {

/// Coordinates of the points of one certificate, one point after the other.
using Numbers = std::vector<double>;

[[nodiscard]] inline std::string as_code(const Numbers& x) {
    std::string s = "{";
    for (const double c : x) s += (s.size() > 1 ? ", " : "") + as_code(c);
    return s + "}";
}

namespace filter_errors {

/// error / (u m^degree)
inline double units(const mpq_class& error, double m, int degree) {
    mpq_class unit(bounds::u);
    for (int i = 0; i < degree; ++i) unit *= mpq_class(m);
    const mpq_class r = error / unit;
    return r.get_d();
}
/// sqrt(x) to a hundred bits and more, whatever the magnitudes in the range of the filter.
inline mpq_class root(const mpq_class& x) {
    const mpf_class r = sqrt(mpf_class(x, 2200));
    return mpq_class(r);
}

inline Point point(const Numbers& x, std::size_t i) { return {x[2 * i], x[2 * i + 1]}; }
inline Vector_2<mpq_class> exact_difference(const Point& a, const Point& b) {
    return {mpq_class(mpq_class(a[0]) - mpq_class(b[0])), mpq_class(mpq_class(a[1]) - mpq_class(b[1]))};
}

template <class T>
std::array<Vector_3<T>, 4> differences(const Numbers& x) {
    std::array<Vector_3<T>, 4> d;
    for (std::size_t i = 0; 3 * i + 3 < x.size(); ++i) {
        const auto at = [&](std::size_t k) { return T(T(x[3 * i + 3 + k]) - T(x[k])); };
        d[i] = {at(0), at(1), at(2)};
    }
    return d;
}

}  // namespace filter_errors

/// In 2D, in units of u times the power of m that the bound has.
struct Plane_errors {
    double determinant = 0;  ///< of |determinant~ - determinant|
    double roots = 0;        ///< of the roots, from below, less their own rounding; for a triangle relative, in u
};

[[nodiscard]] inline Plane_errors triangle_errors(const Numbers& x) {
    using namespace filter_errors;
    const Point a = point(x, 0), b = point(x, 1), c = point(x, 2);
    const auto u = detail::difference(b, a), v = detail::difference(c, a);
    const double m = std::max(detail::magnitude(u), detail::magnitude(v));
    if (!(m > 0)) return {};
    const auto rounded = orientation_terms(u, v, detail::difference(c, b));
    const auto U = exact_difference(b, a), V = exact_difference(c, a), W = exact_difference(c, b);
    const mpq_class determinant = U.x * V.y - U.y * V.x;
    const mpq_class longest = std::max(
        {mpq_class(U.x * U.x + U.y * U.y), mpq_class(V.x * V.x + V.y * V.y), mpq_class(W.x * W.x + W.y * W.y)});
    const mpq_class error = abs(mpq_class(rounded.determinant) - determinant);
    const mpq_class roots = 2 * root(longest);
    const double computed = std::sqrt(rounded.inner) + std::sqrt(rounded.outer);
    const mpq_class missing = (roots - mpq_class(computed)) / roots;
    return {units(error, m, 2), units(missing, 1, 0)};
}

[[nodiscard]] inline Plane_errors bicell_errors(const Numbers& x) {
    using namespace filter_errors;
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
    const mpq_class roots = root(nx * nx + ny * ny) + root(mx * mx + my * my);

    const mpq_class error = abs(mpq_class(rounded.determinant) - determinant);
    const mpq_class computed(std::sqrt(rounded.inner) + std::sqrt(rounded.outer));
    // Squares, roots and their sum: 3.5 u relative, which is in the tail.
    const mpq_class missing = roots - computed - mpq_class(3.5 * bounds::u) * computed;
    return {units(error, m, 4), units(missing, m, 3)};
}

/// In 3D, in the order of bounds.h.
struct Space_errors {
    double orientation = 0, slabs = 0, insphere = 0, norms = 0, side = 0;
};

/// Of five points {a, b, c, p, q}; of the first cell the orientation a, b, c, q.
[[nodiscard]] inline Space_errors space_errors(const Numbers& x) {
    using namespace filter_errors;
    const auto d = differences<double>(x);
    const auto D = differences<mpq_class>(x);
    Space_errors e;
    double m = std::max({detail::magnitude(d[0]), detail::magnitude(d[1]), detail::magnitude(d[3])});
    if (!(m > 0)) return {};
    // Roots are compared after subtracting the rounding of squares, roots and their sum: 4 u relative, which is in the
    // tail.
    const auto short_by = [](const mpq_class& truth, double computed) {
        return mpq_class(truth - mpq_class(computed) * (1 + mpq_class(4 * bounds::u)));
    };
    const auto t = orientation_terms(d[0], d[1], d[3]);
    const auto T = orientation_terms(D[0], D[1], D[3]);
    e.orientation = units(abs(mpq_class(t.determinant) - T.determinant), m, 3);
    e.slabs = units(short_by(2 * root(T.inner), 2 * std::sqrt(t.inner)), m, 2);

    m = std::max(m, detail::magnitude(d[2]));
    const auto s = annulus_terms(d[0], d[1], d[2], d[3]);
    const auto S = annulus_terms(D[0], D[1], D[2], D[3]);
    e.insphere = units(abs(mpq_class(s.determinant) - S.determinant), m, 5);
    for (std::size_t k = 0; k < partitions_3; ++k) {
        const double computed = std::sqrt(s.inner[k]) + std::sqrt(s.outer[k]);
        e.norms = std::max(e.norms, units(short_by(root(S.inner[k]) + root(S.outer[k]), computed), m, 4));
        e.side = std::max(e.side, units(abs(mpq_class(s.side[k]) - S.side[k]), m, 3));
    }
    return e;
}

/// The share of the half width by which a stage's tolerance is too small; 0 where the stage does not return a
/// tolerance.
template <class Truth>
[[nodiscard]] double slack(const Truth& truth, const std::optional<Certificate_value>& answer) {
    if (!answer || answer->sign <= 0 || truth.sign() <= 0 || !(answer->tolerance > 0x1p-1000)) return 0;
    return truth.enclosure().slack(answer->tolerance);
}

/// One number to be maximised: an error in the units of its bound, or the slack of a tolerance in units of 2^-10.
struct Climb {
    const char* name;
    std::size_t size;  ///< coordinates
    double bound;
    double (*value)(const Numbers&);
};

namespace filter_errors {

inline Point_3 point_3(const Numbers& x, std::size_t i) { return {x[3 * i], x[3 * i + 1], x[3 * i + 2]}; }
template <std::optional<Certificate_value> Answers::*stage>
double triangle_slack(const Numbers& x) {
    const Triangle t{point(x, 0), point(x, 1), point(x, 2)};
    return 1024 * slack(Triangle_truth(t), answers_of(t).*stage);
}
template <std::optional<Certificate_value> Answers::*stage>
double bicell_slack(const Numbers& x) {
    const Bicell c{point(x, 0), point(x, 1), point(x, 2), point(x, 3)};
    return is_bicell(c) ? 1024 * slack(Bicell_truth(c), answers_of(c).*stage) : 0;
}
template <std::optional<Certificate_value> Answers::*stage>
double tetrahedron_slack(const Numbers& x) {
    const Tetrahedron t{point_3(x, 0), point_3(x, 1), point_3(x, 2), point_3(x, 3)};
    return 1024 * slack(Tetrahedron_truth(t), answers_of(t).*stage);
}
template <std::optional<Certificate_value> Answers::*stage>
double bicell_3_slack(const Numbers& x) {
    const Bicell_3 c{point_3(x, 0), point_3(x, 1), point_3(x, 2), point_3(x, 3), point_3(x, 4)};
    if (exact_orientation(c.a, c.b, c.c, c.q) <= 0 || exact_orientation(c.a, c.b, c.c, c.p) >= 0) return 0;
    return 1024 * slack(Bicell_3_truth(c, false), answers_of(c, Cell_widths::never).*stage);
}

}  // namespace filter_errors

/// The allowed slack of a stage's tolerance, in units of 2^-10. The filter subtracts the errors of determinant and
/// norms, each at most filter_slack of the computed value; the computed value may itself be off by as much again, and
/// the last term is of second order.
inline constexpr double filter_gives_away =
    1024 * (4 * bounds::filter_slack + 16 * bounds::filter_slack * bounds::filter_slack);
inline constexpr double interval_gives_away = 1024 * bounds::interval_slack * (1 + 0x1p-40);

/// All numbers that are maximised. The names are those of worst_cases.cpp.
[[nodiscard]] inline const std::vector<Climb>& climbs() {
    using namespace filter_errors;
    static const std::vector<Climb> all{
        {"orientation_2", 6, bounds::orientation_2, [](const Numbers& x) { return triangle_errors(x).determinant; }},
        {"orientation_2 roots", 6, bounds::tail, [](const Numbers& x) { return triangle_errors(x).roots; }},
        {"annulus_2_incircle", 8, bounds::annulus_2_incircle,
         [](const Numbers& x) { return bicell_errors(x).determinant; }},
        {"annulus_2_norms", 8, bounds::annulus_2_norms, [](const Numbers& x) { return bicell_errors(x).roots; }},
        {"orientation_3", 15, bounds::orientation_3, [](const Numbers& x) { return space_errors(x).orientation; }},
        {"orientation_3_norms", 15, bounds::orientation_3_norms,
         [](const Numbers& x) { return space_errors(x).slabs; }},
        {"annulus_3_insphere", 15, bounds::annulus_3_insphere,
         [](const Numbers& x) { return space_errors(x).insphere; }},
        {"annulus_3_norms", 15, bounds::annulus_3_norms, [](const Numbers& x) { return space_errors(x).norms; }},
        {"annulus_3_side", 15, bounds::annulus_3_side, [](const Numbers& x) { return space_errors(x).side; }},
        {"triangle, filter gives away", 6, filter_gives_away, triangle_slack<&Answers::filter>},
        {"triangle, intervals give away", 6, interval_gives_away, triangle_slack<&Answers::interval>},
        {"bi-cell, filter gives away", 8, filter_gives_away, bicell_slack<&Answers::filter>},
        {"bi-cell, intervals give away", 8, interval_gives_away, bicell_slack<&Answers::interval>},
        {"tetrahedron, filter gives away", 12, filter_gives_away, tetrahedron_slack<&Answers::filter>},
        {"tetrahedron, intervals give away", 12, interval_gives_away, tetrahedron_slack<&Answers::interval>},
        {"bi-cell in space, filter gives away", 15, filter_gives_away, bicell_3_slack<&Answers::filter>},
        {"bi-cell in space, intervals give away", 15, interval_gives_away, bicell_3_slack<&Answers::interval>},
    };
    return all;
}

/// Climbs from x by changing a coordinate or two at a time, within `reach`; x ends where the greatest value found is.
template <class Value>
double climb(Numbers& x, double reach, Random& random, int steps, Value value) {
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

/// A start for climbing: anywhere, or where differences are just above 1 and a rounding error is largest relative to
/// the number.
[[nodiscard]] inline Numbers start(std::size_t n, std::size_t dimension, Random& random) {
    const auto near = [&random](double c) { return c * (1 + std::ldexp(unit(random), -integer(random, 1, 50))); };
    Numbers x(n);
    switch (random() % 3) {
        case 0:
            for (double& c : x) c = between(random, -0.5, 0.5);
            break;
        case 1:
            for (double& c : x) c = near(random() % 2 == 0 ? 1 : -1);
            for (std::size_t i = 0; i < dimension; ++i)
                x[i] = std::ldexp(between(random, -1, 1), -integer(random, 1, 53));
            break;
        default:
            for (double& c : x) c = near(random() % 2 == 0 ? 0.5 : -0.5);
    }
    return x;
}

}  // namespace annulus::testing
