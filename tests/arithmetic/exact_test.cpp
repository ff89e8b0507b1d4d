// SPDX-License-Identifier: GPL-3.0-or-later
// Doubles as integers, and the one rounded operation of the exact stage.

#include <support/arbitrary.h>
#include <support/catch.h>

#include <annulus/arithmetic/exact.h>

#include <gmpxx.h>
#include <mpfr.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

mpq_class power_of_two(long exponent) {
    mpq_class r(1);
    if (exponent >= 0) mpq_mul_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(exponent));
    else mpq_div_2exp(r.get_mpq_t(), r.get_mpq_t(), static_cast<mp_bitcnt_t>(-exponent));
    return r;
}

std::string as_code(const std::vector<double>& x) {
    std::string text = "{";
    for (const double c : x) text += annulus::testing::as_code(c) + ", ";
    return text + "}";
}

bool round_trips(const std::vector<double>& x) {
    const Scaled_integers z(x);
    if (z.integer.size() != x.size()) return false;
    const mpq_class unit_of_all = power_of_two(z.exponent);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const mpq_class back = mpq_class(z.integer[i]) * unit_of_all;
        if (back != mpq_class(x[i])) return false;
    }
    return true;
}

/// An MPFR number of 1,000 bits.
struct Number {
    mpfr_t value;
    Number() { mpfr_init2(value, 1000); }
    ~Number() { mpfr_clear(value); }
    Number(const Number&) = delete;
    Number& operator=(const Number&) = delete;
};

void quotient(Number& r, const mpz_class& numerator, const mpz_class& a, const mpz_class& b, long exponent) {
    Number root;
    mpfr_set_z(r.value, a.get_mpz_t(), MPFR_RNDN);
    mpfr_sqrt(r.value, r.value, MPFR_RNDN);
    mpfr_set_z(root.value, b.get_mpz_t(), MPFR_RNDN);
    mpfr_sqrt(root.value, root.value, MPFR_RNDN);
    mpfr_add(r.value, r.value, root.value, MPFR_RNDN);
    mpfr_set_z(root.value, numerator.get_mpz_t(), MPFR_RNDN);
    mpfr_div(r.value, root.value, r.value, MPFR_RNDN);
    mpfr_mul_2si(r.value, r.value, exponent, MPFR_RNDN);
}

}  // namespace

TEST_CASE("doubles are integers times one power of two, exactly", "[arithmetic]") {
    REQUIRE(for_all("any numbers of the domain", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 20; ++i) {
            std::vector<double> x(static_cast<std::size_t>(integer(random, 1, 10)));
            for (double& c : x) c = any_in_domain(random);
            if (!round_trips(x)) RC_FAIL(as_code(x));
        }
    }));
    REQUIRE(for_all("numbers of one magnitude", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 20; ++i) {
            const int exponent = integer(random, -1074, 500);
            std::vector<double> x(static_cast<std::size_t>(integer(random, 1, 10)));
            for (double& c : x) c = random() % 8 == 0 ? 0.0 : std::ldexp(between(random, -1, 1), exponent);
            if (!round_trips(x)) RC_FAIL(as_code(x));
        }
    }));
}

TEST_CASE("doubles as integers at the ends of the range", "[arithmetic]") {
    const double smallest = 0x1p-1074, greatest = std::numeric_limits<double>::max();
    CHECK(round_trips({smallest}));
    CHECK(round_trips({-smallest, 0x1p500}));
    CHECK(round_trips({greatest, smallest, -greatest}));
    CHECK(round_trips({0x1.fffffffffffffp-1022, 0x1p-1022, 0x0.fffffffffffffp-1022}));
    CHECK(round_trips({0.0}));
    CHECK(round_trips({0.0, -0.0, 0.0}));
    CHECK(round_trips({-0.0, 1.0, 0.0, 0.1}));
    CHECK(round_trips({}));

    const Scaled_integers zeros(std::vector<double>{0.0, -0.0});
    CHECK(zeros.integer[0] == 0);
    CHECK(zeros.integer[1] == 0);
    CHECK(zeros.exponent == 0);
    // The widest spread in the domain: the stated 1,600 bits.
    const Scaled_integers wide(std::vector<double>{0x1p500, smallest});
    CHECK(mpz_sizeinbase(wide.integer[0].get_mpz_t(), 2) <= 1700);
    CHECK(squared(mpz_class(-12)) == 144);
}

TEST_CASE("scaled integers do not depend on a common power of two", "[arithmetic]") {
    REQUIRE(for_all("even where the numbers become subnormal", [](const Seed& seed) {
        Random random = seed.random();
        std::vector<double> x(4), y(4);
        const int exponent = integer(random, -1068, 480);
        for (std::size_t i = 0; i < 4; ++i) {
            x[i] = integer(random, -1000, 1000);
            y[i] = std::ldexp(x[i], exponent);
        }
        const Scaled_integers zx(x), zy(y);
        for (std::size_t i = 0; i < 4; ++i) RC_ASSERT(zx.integer[i] == zy.integer[i]);
        const bool zero = x == std::vector<double>(4, 0.0);
        RC_ASSERT(zero || zy.exponent == zx.exponent + exponent);
    }));
}

TEST_CASE("the quotient by roots is below the truth and within a unit in the last place", "[arithmetic]") {
    gmp_randclass bits(gmp_randinit_mt);
    REQUIRE(for_all("integers of up to 4,000 bits", [&bits](const Seed& seed) {
        Random random = seed.random();
        bits.seed(static_cast<unsigned long>(seed.value));
        const auto draw = [&](int most) {
            mpz_class z = bits.get_z_bits(static_cast<mp_bitcnt_t>(integer(random, 1, most)));
            return random() % 4 == 0 ? mpz_class(z * z) : z;
        };
        for (int i = 0; i < 30; ++i) {
            const mpz_class numerator = draw(2000), a = draw(2000);
            mpz_class b = random() % 8 == 0 ? a : draw(2000);
            if (sgn(a) == 0 && sgn(b) == 0) b = 1;
            // Centred where the result is about 2^k with k a bit beyond the exponents of doubles.
            const auto size = [](const mpz_class& z) { return static_cast<long>(mpz_sizeinbase(z.get_mpz_t(), 2)); };
            const long exponent = integer(random, -1100, 1050) - size(numerator) + std::max(size(a), size(b)) / 2;
            const double y = quotient_by_roots_lower(numerator, a, b, exponent);
            Number truth;
            quotient(truth, numerator, a, b, exponent);
            std::ostringstream text;
            text << numerator << " / (sqrt(" << a << ") + sqrt(" << b << ")) * 2^" << exponent;
            if (!(y >= 0 && std::isfinite(y))) RC_FAIL(text.str());
            // The reference is rounded itself, in its thousandth bit: one part in 2^990 of room.
            Number ratio;
            mpfr_mul_2si(ratio.value, truth.value, -990, MPFR_RNDU);
            mpfr_add(ratio.value, ratio.value, truth.value, MPFR_RNDU);
            if (mpfr_cmp_d(ratio.value, y) < 0) RC_FAIL("above: " + text.str());
            // The next double up, and be it infinity, is above the truth less 2^-100 of it.
            mpfr_mul_2si(ratio.value, truth.value, -100, MPFR_RNDU);
            mpfr_sub(ratio.value, truth.value, ratio.value, MPFR_RNDD);
            if (y < std::numeric_limits<double>::max() && sgn(numerator) > 0 &&
                mpfr_cmp_d(ratio.value, std::nextafter(y, HUGE_VAL)) >= 0)
                RC_FAIL("not tight: " + text.str());
        }
    }));
}

TEST_CASE("quotients by roots that are known", "[arithmetic]") {
    const double smallest = 0x1p-1074, greatest = std::numeric_limits<double>::max();
    CHECK(quotient_by_roots_lower(0, 1, 1, 0) == 0.0);
    CHECK(quotient_by_roots_lower(0, 0, 7, 5000) == 0.0);
    CHECK(quotient_by_roots_lower(12, 4, 16, 0) == 2.0);
    CHECK(quotient_by_roots_lower(12, 0, 16, 0) == 3.0);
    CHECK(quotient_by_roots_lower(12, 16, 0, -1) == 1.5);
    // 1 / (2 sqrt 2), rounded down
    const double y = quotient_by_roots_lower(1, 2, 2, 0);
    CHECK(y == Approx(0.35355339059327376).epsilon(1e-15));
    CHECK(mpq_class(y) * mpq_class(y) * 8 < 1);
    CHECK(mpq_class(std::nextafter(y, 1.0)) * mpq_class(std::nextafter(y, 1.0)) * 8 > 1);

    SECTION("a truth just below a double is not taken for it") {
        // Each is 1 less a part in 2^200 or less, far beyond the working precision, by another of the operands.
        const mpz_class n = mpz_class(1) << 200, square(n * n), more(square + 1), less(n - 1), twice(2 * n);
        const double below = std::nextafter(1.0, 0.0);
        CHECK(quotient_by_roots_lower(n, square, 0, 0) == 1.0);
        CHECK(quotient_by_roots_lower(twice, square, square, 0) == 1.0);
        CHECK(quotient_by_roots_lower(less, square, 0, 0) == below);
        CHECK(quotient_by_roots_lower(n, more, 0, 0) == below);
        CHECK(quotient_by_roots_lower(n, 0, more, 0) == below);
        CHECK(quotient_by_roots_lower(twice, more, square, 0) == below);
        CHECK(quotient_by_roots_lower(twice, square, more, 0) == below);
        CHECK(quotient_by_roots_lower(n, square, 1, 0) == below);
        CHECK(quotient_by_roots_lower(n, 1, square, 0) == below);
    }
    SECTION("overflow is the largest double") {
        CHECK(quotient_by_roots_lower(1, 1, 0, 1023) == 0x1p1023);
        CHECK(quotient_by_roots_lower(1, 1, 0, 1024) == greatest);
        CHECK(quotient_by_roots_lower(1, 1, 1, 1000000) == greatest);
    }
    SECTION("underflow is a subnormal or zero, below the truth") {
        CHECK(quotient_by_roots_lower(1, 1, 0, -1074) == smallest);
        CHECK(quotient_by_roots_lower(3, 4, 0, -1074) == smallest);
        CHECK(quotient_by_roots_lower(1, 1, 0, -1075) == 0.0);
        CHECK(quotient_by_roots_lower(1, 2, 0, -1074) == 0.0);
        CHECK(quotient_by_roots_lower(7, 1, 0, -1074) == 7 * smallest);
        CHECK(quotient_by_roots_lower(1, 1, 1, -1000000) == 0.0);
    }
}

TEST_CASE("the quotient is the largest double not above the truth, ties included", "[arithmetic]") {
    // sqrt(a) + sqrt(b) a whole number: the truth is a fraction, often a double.
    for (long p = 1; p < 400; ++p)
        for (const long k : {1L, 2L, 3L, 5L, 8L}) {
            const double y = quotient_by_roots_lower(p, k * k, 9 * k * k, -7);  // p / 4k / 128
            const mpq_class truth = mpq_class(p, 512 * k);
            CHECK(mpq_class(y) <= truth);
            CHECK(mpq_class(std::nextafter(y, 1e9)) > truth);
            CHECK(is_at_least(p, k * k, 9 * k * k, -7, y));
            CHECK(!is_at_least(p, k * k, 9 * k * k, -7, std::nextafter(y, 1e9)));
        }
    // One part in 2^200 below and above a tie.
    const mpz_class large = mpz_class(1) << 200;
    CHECK(quotient_by_roots_lower(4 * large, 4 * large * large, 4 * large * large, 0) == 1.0);
    CHECK(quotient_by_roots_lower(4 * large - 1, 4 * large * large, 4 * large * large, 0) == std::nextafter(1.0, 0.0));
    CHECK(quotient_by_roots_lower(4 * large + 1, 4 * large * large, 4 * large * large, 0) == 1.0);
    CHECK(quotient_by_roots_lower(4 * large, 4 * large * large + 1, 4 * large * large, 0) == std::nextafter(1.0, 0.0));
    // A truth of 1 that 128 bits approximate from below: every number in it is longer.
    const mpz_class longer = large + 1;
    CHECK(quotient_by_roots_lower(4 * longer, 4 * longer * longer, 4 * longer * longer, 0) == 1.0);
    // 3.75 less almost 2^-126: everything on the way has 128 bits but the quotient, which must not be rounded to 3.75.
    const mpz_class whole = (mpz_class(1) << 62) + 1;
    const mpz_class numerator = 15 * whole * (mpz_class(1) << 62) - 1;
    const mpz_class square = whole * whole * (mpz_class(1) << 126);
    CHECK(quotient_by_roots_lower(numerator, square, square, 0) == std::nextafter(3.75, 0.0));
    // The ends of the range of doubles.
    CHECK(quotient_by_roots_lower(2, 1, 1, -1074) == 0x1p-1074);
    CHECK(quotient_by_roots_lower(2, 1, 1, -1075) == 0.0);
    CHECK(quotient_by_roots_lower(3, 1, 1, -1074) == 0x1p-1074);
    CHECK(quotient_by_roots_lower(2, 1, 1, 1023) == 0x1p1023);
    CHECK(quotient_by_roots_lower(2, 1, 1, 1024) == std::numeric_limits<double>::max());
    CHECK(is_at_least(0, 1, 1, 0, 0.0));
}

TEST_CASE("a quotient that is a double is found, however long the roots are", "[arithmetic]") {
    // Longer than MPFR's working precision: every operation loses something, and only the tie test sees the double.
    REQUIRE(for_all("of roots up to 240 bits", [](const Seed& seed) {
        Random random = seed.random();
        const auto bits = [&](int count) {
            mpz_class z = 1;
            for (int i = 1; i < count; ++i) z = 2 * z + static_cast<unsigned long>(random() & 1U);
            return z;
        };
        for (int i = 0; i < 100; ++i) {
            const mpz_class a = bits(integer(random, 100, 240)), b = bits(integer(random, 100, 240)), y = bits(53);
            const int exponent = integer(random, -200, 200);
            const mpz_class numerator = y * (a + b);
            const double expected = std::ldexp(y.get_d(), exponent);
            if (quotient_by_roots_lower(numerator, a * a, b * b, exponent) != expected)
                RC_FAIL("less than the quotient: " + numerator.get_str());
            if (quotient_by_roots_lower(numerator - 1, a * a, b * b, exponent) >= expected)
                RC_FAIL("more than the quotient: " + numerator.get_str() + " - 1");
        }
    }));
}
