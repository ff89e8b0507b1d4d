// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where points of a certificate are after an exact move, and the signs there, in integers. Nothing is shared with the
// library.

#include <support/squeezes.h>

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace annulus::testing {

/// Exact positions of points, times some power of two.
template <int d, std::size_t n>
using Places = std::array<Vector_of<mpz_class, d>, n>;

namespace squeezing {

/// x = integer * 2^exponent; the exponent of 0 is as great as any.
struct Dyadic {
    long mantissa = 0;
    int exponent = 4000;
    explicit Dyadic(double x) {
        if (x == 0.0) return;
        mantissa = static_cast<long>(std::ldexp(std::frexp(x, &exponent), 53));
        exponent -= 53;
    }
};

}  // namespace squeezing

/// x, every point `length` in its direction.
template <int d, std::size_t n>
[[nodiscard]] Places<d, n> moved(const Points_of_certificate<d, n>& x, const Points_of_certificate<d, n>& direction,
                                 double length) {
    using squeezing::Dyadic;
    const Dyadic l(length);
    int least = 4000;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < d; ++k)
            least = std::min({least, Dyadic(x[i][k]).exponent, l.exponent + Dyadic(direction[i][k]).exponent});
    Places<d, n> y;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < d; ++k) {
            const Dyadic from(x[i][k]), step(direction[i][k]);
            const auto shifted = [least](const mpz_class& z, int exponent) {
                return z == 0 ? z : mpz_class(z << static_cast<mp_bitcnt_t>(exponent - least));
            };
            y[i][k] = shifted(from.mantissa, from.exponent) +
                      shifted(mpz_class(l.mantissa) * step.mantissa, l.exponent + step.exponent);
        }
    return y;
}

/// Sign of the orientation of the points `at`, which are d + 1.
template <int d, std::size_t n>
[[nodiscard]] int sign_of_orientation(const Places<d, n>& x, const std::array<std::size_t, d + 1>& at) {
    std::array<Vector_of<mpz_class, d>, d> rows;
    for (std::size_t i = 0; i < d; ++i) rows[i] = squeezing::difference(x[at[i + 1]], x[at[0]]);
    return sgn(squeezing::dot(rows[0], squeezing::cofactors(rows, 0)));
}
template <int d>
[[nodiscard]] int sign_of_simplex(const Places<d, d + 1>& x) {
    std::array<std::size_t, d + 1> at{};
    for (std::size_t i = 0; i <= d; ++i) at[i] = i;
    return sign_of_orientation<d, d + 1>(x, at);
}
/// Of the cell {facet.., q}, and of the cell of p turned so that it is positive too.
template <int d>
[[nodiscard]] int sign_of_cell(const Places<d, d + 2>& x, bool with_q) {
    std::array<std::size_t, d + 1> at{};
    for (std::size_t i = 0; i < d; ++i) at[i] = i;
    at[d] = with_q ? d + 1 : d;
    return with_q ? sign_of_orientation<d, d + 2>(x, at) : -sign_of_orientation<d, d + 2>(x, at);
}
/// Positive when p is strictly outside the sphere of the positive cell {facet.., q}: the lifted determinant with p as
/// the origin.
template <int d>
[[nodiscard]] int sign_of_empty_sphere(const Places<d, d + 2>& x) {
    std::array<Vector_of<mpz_class, d>, d + 1> y;
    for (std::size_t i = 0; i < d; ++i) y[i] = squeezing::difference(x[i], x[d]);
    y[d] = squeezing::difference(x[d + 1], x[d]);
    mpz_class sum = 0;
    for (std::size_t i = 0; i <= d; ++i) {
        std::array<Vector_of<mpz_class, d>, d> rows;
        for (std::size_t k = 0, r = 0; k <= d; ++k)
            if (k != i) rows[r++] = y[k];
        const mpz_class term = squeezing::dot(y[i], y[i]) * squeezing::dot(rows[0], squeezing::cofactors(rows, 0));
        if (i % 2 == 0) sum += term;
        else sum -= term;
    }
    // With all lifts 1 it is the orientation of the cell: p in its middle is inside.
    return -sgn(sum);
}

}  // namespace annulus::testing
