// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/circumcentre.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/error.h>
#include <annulus/predicate/bounds.h>
#include <annulus/space/euclidean.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace annulus::inline v1 {

namespace {

/// In a unit in which no value is above 2, underflow changes each term by less than this.
constexpr double lost = 0x1p-1000;
/// Errors above this many shortest edges are not good enough.
constexpr double good_enough = 0x1p-40;

template <std::size_t n>
double absolute_sum(const std::array<double, n>& x) {
    double sum = 0;
    for (const double c : x) sum += std::fabs(c);
    return sum;
}

/// The sums of absolute values of the terms of the numerator, over all coordinates, and of the denominator.
struct Magnitudes {
    double numerator = 0, denominator = 0;
};
Magnitudes magnitudes(const std::array<std::array<double, 2>, 2>& v) {
    const auto& [b, c] = v;
    const double bb = b[0] * b[0] + b[1] * b[1];
    const double cc = c[0] * c[0] + c[1] * c[1];
    return {bb * absolute_sum(c) + cc * absolute_sum(b), std::fabs(b[0] * c[1]) + std::fabs(b[1] * c[0])};
}
Magnitudes magnitudes(const std::array<std::array<double, 3>, 3>& v) {
    Magnitudes m;
    for (std::size_t s = 0; s < 3; ++s) {
        const auto& a = v[s];
        const auto& p = v[(s + 1) % 3];
        const auto& q = v[(s + 2) % 3];
        const double square = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = (k + 1) % 3;
            const std::size_t j = (k + 2) % 3;
            const double minor = std::fabs(p[i] * q[j]) + std::fabs(p[j] * q[i]);
            m.numerator += square * minor;
            if (s == 0) m.denominator += std::fabs(a[k]) * minor;
        }
    }
    return m;
}

template <class T>
Circumcentre_2<T> terms(const std::array<std::array<T, 2>, 2>& v) {
    return {v[0], v[1]};
}
template <class T>
Circumcentre_3<T> terms(const std::array<std::array<T, 3>, 3>& v) {
    return {v[0], v[1], v[2]};
}

/// numerator / denominator * 2^exponent with two roundings at most (one to 64 bits, one to a double), where nothing
/// underflows.
double quotient(const mpz_class& numerator, const mpz_class& denominator, long exponent) {
    if (sgn(numerator) == 0) return 0;
    const auto bits = [](const mpz_class& x) { return static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); };
    const long shift = std::max(0L, 66 + bits(denominator) - bits(numerator));
    mpz_class q = numerator;
    mpz_mul_2exp(q.get_mpz_t(), q.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    q /= denominator;
    long scale = 0;
    const double mantissa = mpz_get_d_2exp(&scale, q.get_mpz_t());
    return std::ldexp(mantissa, static_cast<int>(std::clamp(scale + exponent - shift, -3000L, 3000L)));
}

template <int d>
[[gnu::noinline]] Circumcentre<d> exact_circumcentre(const Corners<d>& x, double scale) {
    std::array<double, static_cast<std::size_t>(d * (d + 1))> numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = x[i / d][i % d];
    const Scaled_integers exactly(numbers);
    std::array<std::array<mpz_class, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d)> v;
    for (std::size_t i = 0; i < d; ++i)
        v[i] = Euclidean<d>::difference(&exactly.integer[(i + 1) * d], &exactly.integer[0], Exact_minus());
    const auto t = terms(v);
    if (sgn(t.denominator) <= 0)
        throw Error(Error_code::bad_input, "a cell is not positively oriented: its Voronoi vertex is nowhere");
    const mpz_class twice = 2 * t.denominator;
    const long exponent = exactly.exponent + std::ilogb(scale);
    Circumcentre<d> out;
    for (std::size_t k = 0; k < d; ++k) out.offset[k] = quotient(t.numerator[k], twice, exponent);
    out.error = 4 * bounds::u * absolute_sum(out.offset) + lost;
    return out;
}

}  // namespace

// Errors in doubles, counted in u per term; what is of second order is in the larger constants that are used
// (predicate/bounds.h). A difference of two coordinates has 1 (scaling by a power of two none). In 2D: a square 2+1, a
// sum of two squares 4; times a coordinate 6; a difference of two 7 of the magnitude: 8 is used; denominator 3 and 1:
// 4, 6 is used. In 3D: a sum of three squares 5, a minor 2+1+1 = 4, times a sum of squares 10, sums of three 12 of the
// magnitude: 16 is used; denominator 4+1+1+2 = 8: 10 is used. The magnitudes are themselves computed, too small by as
// many u at most, which the larger constants cover as well: proofs/gappa/circumcentre_2.g, circumcentre_3.g.
//
// With N and D computed, eN and eD their errors and d = D - eD > 0 below the true denominator,
//     |N / 2D - truth| <= (eN + |N / D| eD) / 2d,
// and the division has another u.
template <int d>
Circumcentre<d> circumcentre(const Corners<d>& x, double scale) {
    constexpr double u = bounds::u;
    constexpr double of_numerator = (d == 2 ? bounds::circumcentre_2_numerator : bounds::circumcentre_3_numerator) * u;
    constexpr double of_denominator =
        (d == 2 ? bounds::circumcentre_2_denominator : bounds::circumcentre_3_denominator) * u;
    std::array<Coordinates<d>, static_cast<std::size_t>(d)> v;
    double shortest = HUGE_VAL;
    for (std::size_t i = 0; i < d; ++i) {
        v[i] = Euclidean<d>::difference(x[i + 1], x[0], [scale](double a, double b) { return (a - b) * scale; });
        shortest = std::min(shortest, absolute_sum(v[i]));
        for (std::size_t j = 0; j < i; ++j) {
            double length = 0;
            for (std::size_t k = 0; k < d; ++k) length += std::fabs(v[i][k] - v[j][k]);
            shortest = std::min(shortest, length);
        }
    }
    const auto t = terms(v);
    const Magnitudes m = magnitudes(v);
    const double error_of_numerator = of_numerator * m.numerator + lost;
    const double error_of_denominator = of_denominator * m.denominator + lost;
    const double least = 2 * (t.denominator - error_of_denominator);
    Circumcentre<d> out;
    if (least > 0) {
        for (std::size_t k = 0; k < d; ++k) out.offset[k] = t.numerator[k] / (2 * t.denominator);
        const double length = absolute_sum(out.offset);
        out.error = (1 + 0x1p-40) * ((error_of_numerator + 2 * length * error_of_denominator) / least + 2 * u * length);
        if (out.error <= good_enough * shortest) return out;
    }
    return exact_circumcentre<d>(x, scale);
}

template Circumcentre<2> circumcentre(const Corners<2>&, double);
template Circumcentre<3> circumcentre(const Corners<3>&, double);

}  // namespace annulus::inline v1
