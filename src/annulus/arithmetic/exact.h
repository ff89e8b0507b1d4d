// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>
#include <mpfr.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// a - b as a number. The difference of two mpz_class is an expression that refers to its operands instead.
struct Exact_minus {
    mpz_class operator()(const mpz_class& a, const mpz_class& b) const { return a - b; }
};

/// Doubles as integers times one power of two: x_i = integer[i] * 2^exponent, exactly.
struct Scaled_integers {
    std::vector<mpz_class> integer;
    long exponent = 0;

    /// Precondition: every x is finite. Cost grows with the spread of the exponents (at most 1,600 bits a number
    /// inside the coordinate domain).
    explicit Scaled_integers(std::span<const double> x);
};

[[nodiscard]] inline mpz_class squared(const mpz_class& x) { return x * x; }

/// The largest double not above numerator * 2^exponent / (sqrt(a) + sqrt(b)).
///
/// Preconditions: numerator >= 0, a >= 0, b >= 0, a + b > 0. Ziv's strategy in two steps. First a lower bound with 128
/// bits in MPFR; each operation is rounded in the direction that makes the quotient smaller. If a double may lie
/// between the bound and the true value (always the case when the true value is a double), is_at_least decides
/// exactly. Overflow gives the largest double, underflow zero or a subnormal below the true value.
[[nodiscard]] double quotient_by_roots_lower(const mpz_class& numerator, const mpz_class& a, const mpz_class& b,
                                             long exponent);

/// The tie test: y <= numerator * 2^exponent / (sqrt(a) + sqrt(b)), exactly. Let the integers X and Z have the ratio
/// of the scaled numerator to y. Then the test is r = X^2 - Z^2 (a + b) >= 0 and 4 Z^4 a b <= r^2. Precondition: y is
/// finite and y >= 0.
[[nodiscard]] bool is_at_least(const mpz_class& numerator, const mpz_class& a, const mpz_class& b, long exponent,
                               double y);

}  // namespace annulus::inline v1
