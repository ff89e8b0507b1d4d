// SPDX-License-Identifier: GPL-3.0-or-later
// The error bounds of the filter in space beside the errors it makes, sought by climbing; and the interval stage's numbers beside
// CGAL's intervals.

#include <support/arbitrary.h>
#include <support/stages_3.h>

#include <annulus/certificate/bounds.h>
#include <annulus/certificate/width_terms_3.h>

#include <CGAL/Interval_nt.h>
#include <gmpxx.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Numbers = std::array<double, 15>;

template <class T>
using Differences = std::array<Vector_3<T>, 4>;

template <class T>
Differences<T> differences(const Numbers& x) {
    Differences<T> d;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto at = [&](std::size_t k) { return T(T(x[3 * i + 3 + k]) - T(x[k])); };
        d[i] = {at(0), at(1), at(2)};
    }
    return d;
}

/// Errors in units of u m^k, k the degree: in the order of bounds.h.
struct Errors {
    double orientation = 0, slabs = 0, insphere = 0, norms = 0, side = 0;
};

double units(const mpq_class& error, double m, int degree) {
    mpq_class unit(bounds::u);
    for (int i = 0; i < degree; ++i) unit *= mpq_class(m);
    const mpq_class r = error / unit;
    return r.get_d();
}

mpq_class root(const mpq_class& x) {
    const mpf_class r = sqrt(mpf_class(x, 2200));
    return mpq_class(r);
}

Errors errors(const Numbers& x) {
    const auto d = differences<double>(x);
    const auto D = differences<mpq_class>(x);
    Errors e;
    double m = std::max({detail::magnitude(d[0]), detail::magnitude(d[1]), detail::magnitude(d[3])});
    if (!(m > 0)) return {};
    // Roots are compared less what rounding squares, roots and their sum may take: 4 u relative, which is in the tail.
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

bool within_bounds(const Errors& e) {
    return e.orientation <= bounds::orientation_3 && e.slabs <= bounds::orientation_3_norms &&
           e.insphere <= bounds::annulus_3_insphere && e.norms <= bounds::annulus_3_norms &&
           e.side <= bounds::annulus_3_side;
}

std::string text(const Numbers& x) {
    std::string s = "{";
    for (const double c : x) s += as_code(c) + ", ";
    return s + "}";
}

Numbers start(Random& random) {
    Numbers x;
    const bool corners = random() % 2 == 0;  // differences just above 1, or anywhere
    for (double& c : x)
        c = corners ? (random() % 2 == 0 ? 0.5 : -0.5) * (1 + std::ldexp(unit(random), -integer(random, 1, 50)))
                    : between(random, -0.5, 0.5);
    return x;
}

template <class Value>
double climb(Random& random, int steps, Value value) {
    Numbers x = start(random);
    double best = value(x);
    for (int i = 0; i < steps; ++i) {
        Numbers y = x;
        for (std::uint64_t changes = 1 + random() % 2; changes > 0; --changes) {
            double& c = y[random() % y.size()];
            switch (random() % 3) {
                case 0: c = between(random, -0.6, 0.6); break;
                case 1: c += std::ldexp(between(random, -1, 1), -integer(random, 1, 56)); break;
                default: c = ulp_noise(random, c, 8); break;
            }
        }
        const double v = value(y);
        if (v >= best) best = v, x = y;
    }
    return best;
}

}  // namespace

TEST_CASE("the filter in space is never off by more than its bounds", "[certificate][space]") {
    REQUIRE(rc::check("on coordinates of one magnitude and of many", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 10; ++i) {
            Numbers x = start(random);
            if (i % 2 == 0)
                for (double& c : x) c = std::ldexp(c, -integer(random, 0, 99));
            if (!within_bounds(errors(x))) RC_FAIL(text(x));
        }
    }));
}

TEST_CASE("the filter in space is never off by more than its bounds, sought by climbing", "[certificate][space]") {
    Random random(Catch::rngSeed());
    std::array<double, 5> most{};
    constexpr std::array<double Errors::*, 5> kinds{&Errors::orientation, &Errors::slabs, &Errors::insphere,
                                                    &Errors::norms, &Errors::side};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        for (int again = 0; again < 2; ++again)
            most[i] = std::max(most[i], climb(random, 1000, [&](const Numbers& x) { return errors(x).*kinds[i]; }));
    std::printf(
        "greatest errors found in space, in u (bound): orientation %.2f (%g), its roots %.2f (%g), empty sphere %.2f "
        "(%g), its "
        "roots %.2f (%g), sums of lambda %.2f (%g)\n",
        most[0], bounds::orientation_3, most[1], bounds::orientation_3_norms, most[2], bounds::annulus_3_insphere,
        most[3], bounds::annulus_3_norms, most[4], bounds::annulus_3_side);
    CHECK(most[0] <= bounds::orientation_3);
    CHECK(most[1] <= bounds::orientation_3_norms);
    CHECK(most[2] <= bounds::annulus_3_insphere);
    CHECK(most[3] <= bounds::annulus_3_norms);
    CHECK(most[4] <= bounds::annulus_3_side);
    // The climb gets somewhere.
    CHECK(most[0] > 3);
    CHECK(most[2] > 5);
    CHECK(most[3] > 5);
    CHECK(most[4] > 3);
}

TEST_CASE("the bounds of the norms in space are made of those of the vectors", "[certificate][space]") {
    CHECK(bounds::orientation_3_norms >= std::sqrt(3.0) * 2 * bounds::orientation_3_slab);
    CHECK(bounds::annulus_3_norms >= std::sqrt(3.0) * (bounds::annulus_3_n + bounds::annulus_3_m));
}

TEST_CASE("Boost's intervals and CGAL's enclose the same terms", "[certificate][space]") {
    using Cgal = CGAL::Interval_nt<false>;
    REQUIRE(rc::check("of bi-cells of usual magnitudes", [](const Seed& seed) {
        for_each_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            for (const Point_3* p : c.tuple())
                for (const double x : *p)
                    if (x != 0.0 && (std::fabs(x) < 0x1p-60 || std::fabs(x) > 0x1p60)) return;
            Numbers x;
            std::size_t i = 0;
            for (const Point_3* p : c.tuple())
                for (const double v : *p) x[i++] = v;
            std::array<std::pair<double, double>, 10> boost, cgal;
            {
                const Rounding_guard guard(FE_UPWARD);
                const auto d = differences<Interval>(x);
                const auto t = annulus_terms(d[0], d[1], d[2], d[3]);
                boost[0] = {t.determinant.lower(), t.determinant.upper()};
                for (std::size_t k = 0; k < 4; ++k) boost[1 + k] = {t.inner[k].lower(), t.inner[k].upper()};
                for (std::size_t k = 0; k < 4; ++k) boost[5 + k] = {t.side[k].lower(), t.side[k].upper()};
                boost[9] = {t.cell_q.lower(), t.cell_q.upper()};
            }
            {
                const Cgal::Protector protector;
                const auto d = differences<Cgal>(x);
                const auto t = annulus_terms(d[0], d[1], d[2], d[3]);
                cgal[0] = {t.determinant.inf(), t.determinant.sup()};
                for (std::size_t k = 0; k < 4; ++k) cgal[1 + k] = {t.inner[k].inf(), t.inner[k].sup()};
                for (std::size_t k = 0; k < 4; ++k) cgal[5 + k] = {t.side[k].inf(), t.side[k].sup()};
                cgal[9] = {t.cell_q.inf(), t.cell_q.sup()};
            }
            const auto D = differences<mpq_class>(x);
            const auto T = annulus_terms(D[0], D[1], D[2], D[3]);
            const std::array<mpq_class, 10> truth{T.determinant, T.inner[0], T.inner[1], T.inner[2], T.inner[3],
                                                  T.side[0],     T.side[1],  T.side[2],  T.side[3],  T.cell_q};
            for (std::size_t k = 0; k < truth.size(); ++k) {
                HOLDS(mpq_class(boost[k].first) <= truth[k] && truth[k] <= mpq_class(boost[k].second), c);
                HOLDS(mpq_class(cgal[k].first) <= truth[k] && truth[k] <= mpq_class(cgal[k].second), c);
                // Neither is much wider than the other; a square knows that it is not negative, x * x does not.
                if (k >= 1 && k <= 4) continue;
                const double ours = boost[k].second - boost[k].first, theirs = cgal[k].second - cgal[k].first;
                HOLDS(ours <= 2 * theirs + 0x1p-1000 && theirs <= 8 * ours + 0x1p-1000, c);
            }
        });
    }));
}
