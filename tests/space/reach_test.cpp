// SPDX-License-Identifier: GPL-3.0-or-later
// How far copies of points are needed, compared with rational circumcentres, and which boxes are too thin.
#include <annulus/error.h>
#include <annulus/space/lattice.h>
#include <annulus/space/reach.h>
#include <annulus/space/selling.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Rational_rows = std::array<std::array<mpq_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)>;

/// c with rows_k . c = right_k, by Cramer's rule.
template <int d>
std::array<mpq_class, static_cast<std::size_t>(d)> solved(const Rational_rows<d>& rows,
                                                          const std::array<mpq_class, d>& right) {
    const mpq_class whole = determinant_of_rows(rows);
    std::array<mpq_class, static_cast<std::size_t>(d)> c;
    for (std::size_t i = 0; i < d; ++i) {
        Rational_rows<d> replaced = rows;
        for (std::size_t k = 0; k < d; ++k) replaced[k][i] = right[k];
        c[i] = determinant_of_rows(replaced) / whole;
    }
    return c;
}

/// Twice the largest coordinates in the basis of the vertices of the Voronoi cell, in rational numbers: they are the
/// circumcentres of 0, v, v + w, .. for the orders v, w, .. of a superbase.
template <int d>
std::array<mpq_class, static_cast<std::size_t>(d)> reach_by_centres(const Superbase<d>& base,
                                                                    const typename Box<d>::Vectors& vectors) {
    Rational_rows<d> columns;
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t j = 0; j < d; ++j) columns[i][j] = mpq_class(vectors[j][i]);
    std::array<mpq_class, static_cast<std::size_t>(d)> reach;
    std::array<std::size_t, static_cast<std::size_t>(d + 1)> order{};
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
        Rational_rows<d> corner;
        std::array<mpq_class, static_cast<std::size_t>(d)> half;
        for (std::size_t k = 0; k < d; ++k) {
            if (k > 0) corner[k] = corner[k - 1];
            for (std::size_t i = 0; i < d; ++i) {
                for (std::size_t j = 0; j < d; ++j)
                    corner[k][i] += mpq_class(static_cast<long>(base[order[k]][j])) * columns[i][j];
                half[k] += corner[k][i] * corner[k][i] / 2;
            }
        }
        const auto f = solved<d>(columns, solved<d>(corner, half));
        for (std::size_t j = 0; j < d; ++j) reach[j] = std::max<mpq_class>(reach[j], 2 * abs(f[j]));
    } while (std::next_permutation(order.begin(), order.end()));
    return reach;
}

template <int d>
void expect_reach(const typename Box<d>::Vectors& vectors) {
    const Superbase<d> base = obtuse_superbase<d>(vectors);
    const auto expected = reach_by_centres<d>(base, vectors);
    const Coordinates<d> reach = reach_of<d>(base, vectors);
    for (std::size_t j = 0; j < d; ++j)
        CHECK((mpq_class(reach[j]) >= expected[j] && mpq_class(reach[j]) <= expected[j] * mpq_class(1 + 0x1p-49)));
}

/// What the constructor of Box says; nothing where it accepts the vectors.
template <int d>
std::string refusal_of(const typename Box<d>::Vectors& vectors) {
    try {
        (void)Box<d>(vectors);
    } catch (const Error& e) {
        CHECK(e.code() == Error_code::usage);
        return e.what();
    }
    return {};
}

/// Along the axes, where they are accepted, and turned.
template <int d>
void expect_thin_boxes(double thin, Periodic_cases& cases) {
    CAPTURE(d, std::log10(thin));
    for (const int thin_vectors : {1, d - 1}) {
        const auto v = cases.thin<d>(thin_vectors, thin);
        CHECK(refusal_of<d>(v).empty());
        expect_reach<d>(v);
        const std::string refusal = refusal_of<d>(cases.turned<d>(v));
        if (thin >= 1e-7) CHECK(refusal.empty());
        if (thin <= 1e-9) CHECK(refusal.find(thin > 1e-13 ? "too thin" : "the") != std::string::npos);
        CHECK(refusal.find("skewed") == std::string::npos);
    }
}

}  // namespace

TEST_CASE("The reach is exact, and boxes are refused as too thin where doubles have no digits for them",
          "[space][periodic]") {
    Periodic_cases cases(11);
    for (int k = 0; k < repeats(20); ++k) {
        for (int kind = 0; kind < Periodic_cases::kinds; ++kind) {
            expect_reach<2>(cases.box<2>(kind).vectors());
            expect_reach<3>(cases.box<3>(kind).vectors());
        }
        for (int exponent = 0; exponent <= 15; ++exponent) {
            const double thin = std::pow(10.0, -exponent) * cases.uniform(1, 3);
            expect_thin_boxes<2>(thin, cases);
            expect_thin_boxes<3>(thin, cases);
        }
    }
    // Off the axes, 2e-8 and 4e-9 of its length thick: rounded, the first vector is at no right angle to the second.
    const std::string thin =
        refusal_of<2>({{{0.9771616619466469, 0.21249726215099116}, {-2.1249726215099115e-09, 9.77161661946647e-09}}});
    CHECK(thin.find("too thin in a direction that is not along an axis") != std::string::npos);
    CHECK(refusal_of<2>({{{1, 0}, {0, 1e-30}}}).empty());
    CHECK(refusal_of<2>({{{1, 0}, {40, 1}}}).find("more than eight times as long") != std::string::npos);
    CHECK(refusal_of<2>({{{1, 0}, {1e12, 1}}}).find("more than eight times as long") != std::string::npos);
    CHECK(refusal_of<2>({{{1, 0.7}, {1e-4, -1e-4}}}).find("more than 64 times; reduce it first") != std::string::npos);
}
