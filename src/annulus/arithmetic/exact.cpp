// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/exact.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdlib>

namespace annulus::inline v1 {

Scaled_integers::Scaled_integers(std::span<const double> x) {
    std::vector<int> exponents(x.size());
    int least = INT_MAX;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i] == 0.0) continue;
        (void)std::frexp(x[i], &exponents[i]);
        exponents[i] -= 53;  // x = (53-bit integer) * 2^exponents[i], also for subnormals
        least = std::min(least, exponents[i]);
    }
    exponent = least == INT_MAX ? 0 : least;
    integer.resize(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (x[i] == 0.0) continue;
        integer[i] = std::scalbn(x[i], -exponents[i]);
        mpz_mul_2exp(integer[i].get_mpz_t(), integer[i].get_mpz_t(), static_cast<mp_bitcnt_t>(exponents[i] - least));
    }
}

namespace {

/// An MPFR number with the library's working precision.
class Real {
  public:
    Real() { mpfr_init2(value_, 128); }
    ~Real() { mpfr_clear(value_); }
    Real(const Real&) = delete;
    Real& operator=(const Real&) = delete;
    mpfr_ptr get() { return value_; }

  private:
    mpfr_t value_;
};

}  // namespace

double quotient_by_roots_lower(const mpz_class& numerator, const mpz_class& a, const mpz_class& b, long exponent) {
    Real root_a;
    Real root_b;
    Real result;
    mpfr_set_z(root_a.get(), a.get_mpz_t(), MPFR_RNDU);
    mpfr_sqrt(root_a.get(), root_a.get(), MPFR_RNDU);
    mpfr_set_z(root_b.get(), b.get_mpz_t(), MPFR_RNDU);
    mpfr_sqrt(root_b.get(), root_b.get(), MPFR_RNDU);
    mpfr_add(root_a.get(), root_a.get(), root_b.get(), MPFR_RNDU);
    mpfr_set_z(result.get(), numerator.get_mpz_t(), MPFR_RNDD);
    mpfr_div(result.get(), result.get(), root_a.get(), MPFR_RNDD);
    mpfr_mul_2si(result.get(), result.get(), exponent, MPFR_RNDD);
    const double lower = mpfr_get_d(result.get(), MPFR_RNDD);
    // The true value is below result (1 + 2^-120): six operations lose at most 2^-127 each. Is the next double below
    // that?
    const double next = std::nextafter(lower, HUGE_VAL);
    if (std::isinf(next)) return lower;
    mpfr_set_ui_2exp(root_a.get(), 1, -120, MPFR_RNDU);
    mpfr_add_ui(root_a.get(), root_a.get(), 1, MPFR_RNDU);
    mpfr_mul(result.get(), result.get(), root_a.get(), MPFR_RNDU);
    if (mpfr_cmp_d(result.get(), next) < 0) return lower;
    return is_at_least(numerator, a, b, exponent, next) ? next : lower;
}

bool is_at_least(const mpz_class& numerator, const mpz_class& a, const mpz_class& b, long exponent, double y) {
    if (y == 0.0) return true;
    int of_y = 0;
    mpz_class z(std::ldexp(std::frexp(y, &of_y), 53));
    of_y -= 53;  // y = z * 2^of_y
    mpz_class x(numerator);
    const long shift = exponent - of_y;
    mpz_class& smaller = shift >= 0 ? x : z;
    mpz_mul_2exp(smaller.get_mpz_t(), smaller.get_mpz_t(), static_cast<mp_bitcnt_t>(std::labs(shift)));
    const mpz_class z2 = z * z;
    const mpz_class r = x * x - z2 * (a + b);
    return sgn(r) >= 0 && 4 * z2 * z2 * a * b <= r * r;
}

}  // namespace annulus::inline v1
