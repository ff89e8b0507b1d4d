// SPDX-License-Identifier: GPL-3.0-or-later
// The helpers that round in a direction, compared with rational numbers: each result is a bound, to the last bit, and
// no wider than stated. Their parts are proved in proofs/coq/float_sums.v and float_displacement.v; the known values
// are those of the formulas there.

#include <support/arbitrary.h>
#include <support/catch.h>

#include <annulus/engine/displacement.h>
#include <annulus/engine/expiry.h>

#include <gmpxx.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Rational = mpq_class;

template <int d>
Rational exact_squared_distance(const Coordinates<d>& a, const Coordinates<d>& b) {
    Rational sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
        const Rational c = Rational(a[k]) - Rational(b[k]);
        sum += c * c;
    }
    return sum;
}

/// The largest double whose square is not above x.
double root_below(const Rational& x) {
    // Scaled by 4^k to about 1, because the square of a small number would be 0.
    const long k = (static_cast<long>(mpz_sizeinbase(x.get_den_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(x.get_num_mpz_t(), 2))) /
                   2;
    Rational scaled;
    if (k >= 0) mpq_mul_2exp(scaled.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(2 * k));
    else mpq_div_2exp(scaled.get_mpq_t(), x.get_mpq_t(), static_cast<mp_bitcnt_t>(-2 * k));
    double r = std::ldexp(std::sqrt(scaled.get_d()), -static_cast<int>(k));
    while (Rational(r) * Rational(r) > x) r = std::nextafter(r, 0.0);
    for (;;) {
        const double next = std::nextafter(r, HUGE_VAL);
        if (Rational(next) * Rational(next) > x) return r;
        r = next;
    }
}

/// Positive, now and then with few bits or next to a power of two, where rounding is at its worst.
double positive(Random& random, int low, int high) {
    const int kind = static_cast<int>(random() % 4);
    double m = 1.0 + unit(random);
    if (kind == 0) m = 1.0 + std::ldexp(integer(random, -4, 4), -52);
    if (kind == 1) m = 1.0 + std::ldexp(integer(random, 0, 3), -20);
    return std::ldexp(m, integer(random, low, high));
}

template <int d>
Coordinates<d> vector(Random& random, double scale) {
    Coordinates<d> v;
    for (double& c : v) c = scale * between(random, -1, 1);
    if (random() % 4 == 0) v[random() % static_cast<std::size_t>(d)] = 0.0;
    return v;
}

template <int d>
std::string text(const Coordinates<d>& a, const Coordinates<d>& b) {
    std::string s;
    for (const auto& x : {a, b})
        for (const double c : x) s += as_code(c) + " ";
    return s;
}

template <int d>
void check_distances(const Seed& seed, int low, int high) {
    Random random = seed.random();
    for (int i = 0; i < 200; ++i) {
        const double scale = std::ldexp(1.0, integer(random, low, high));
        const auto a = vector<d>(random, scale);
        auto b = random() % 2 == 0 ? Coordinates<d>{} : vector<d>(random, scale);
        if (random() % 4 == 0)
            for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) b[k] = ulp_noise(random, a[k], 4);
        const Rational truth = exact_squared_distance<d>(a, b);
        const double upper = distance_upper<d>(a, b);
        if (Rational(upper) * Rational(upper) < truth) RC_FAIL("distance_upper is below: " + text<d>(a, b));
        if (truth == 0) continue;
        // The distance is at least this radius: no comparison of squares may say that it is less.
        const double radius = root_below(truth);
        if (squared_distance<d>(a, b) < squared_threshold_lower(radius))
            RC_FAIL("not less than " + as_code(radius) + ": " + text<d>(a, b));
        if (radius < 0x1p-400) continue;
        if (Rational(upper) > Rational(radius) * Rational(1.0 + 0x1p-48))
            RC_FAIL("distance_upper is wide: " + text<d>(a, b));
        const double wider = radius * (1.0 + 0x1p-48);
        if (!(squared_distance<d>(a, b) < squared_threshold_lower(wider)))
            RC_FAIL("less than " + as_code(wider) + ", and not seen: " + text<d>(a, b));
    }
}

}  // namespace

TEST_CASE("Sums are rounded outward, by less than two units in the last place", "[relocation][rounding]") {
    REQUIRE(for_all("of numbers of any magnitude", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 500; ++i) {
            const double a = positive(random, -1074, 500);
            const double b = random() % 3 == 0   ? positive(random, -1074, 500)
                             : random() % 2 == 0 ? std::ldexp(a, -integer(random, 0, 60)) * positive(random, 0, 0)
                                                 : 0.0;
            const Rational sum = Rational(a) + Rational(b);
            const double upper = sum_upper(a, b), lower = sum_lower(a, b);
            if (Rational(upper) < sum) RC_FAIL("sum_upper is below: " + as_code(a) + ", " + as_code(b));
            if (Rational(lower) > sum) RC_FAIL("sum_lower is above: " + as_code(a) + ", " + as_code(b));
            if (sum < Rational(0x1p-900)) continue;
            if (Rational(upper) > sum * Rational(1.0 + 0x1.8p-51) || Rational(lower) < sum * Rational(1.0 - 0x1.8p-51))
                RC_FAIL("wide: " + as_code(a) + ", " + as_code(b));
        }
    }));
    CHECK(sum_upper(1.0, 0.0) == 1.0 + 0x1p-52);
    CHECK(sum_lower(1.0, 0.0) == 1.0 - 0x1p-52);
    CHECK(sum_upper(0.0, 0.0) == 0.0);
    CHECK(sum_upper(0x1p-1074, 0x1p-1074) >= 0x1p-1073);
}

TEST_CASE("Displacements are never taken for shorter than they are", "[relocation][rounding]") {
    REQUIRE(for_all("plane", [](const Seed& seed) { check_distances<2>(seed, -30, 30); }));
    REQUIRE(for_all("space", [](const Seed& seed) { check_distances<3>(seed, -30, 30); }));
    REQUIRE(for_all("plane, where squares underflow", [](const Seed& seed) { check_distances<2>(seed, -1060, -440); }));
    REQUIRE(for_all("space, where squares underflow", [](const Seed& seed) { check_distances<3>(seed, -1060, -440); }));
    REQUIRE(for_all("plane, at the end of the domain", [](const Seed& seed) { check_distances<2>(seed, 490, 500); }));
    REQUIRE(for_all("space, at the end of the domain", [](const Seed& seed) { check_distances<3>(seed, 490, 500); }));
    CHECK(distance_upper<2>({3, 0}, {0, 4}) == 5.0 * (1.0 + 0x1p-49));
    CHECK(distance_upper<2>({0x1p-600, 0}, {0, 0}) == 0x1p-600 * (1.0 + 0x1p-49));
    CHECK(distance_upper<3>({0x1p-1074, 0, 0}, {0, 0, 0}) == 0x1p-1074);
    CHECK(squared_threshold_lower(1.0) == 1.0 - 0x1p-49);
    CHECK(squared_threshold_lower(0x1p-450) == 0.0);
    CHECK(squared_threshold_lower(std::nextafter(0x1p-450, 1.0)) > 0.0);
    CHECK(squared_threshold_lower(0x1p510) == 0x1p1020 * (1.0 - 0x1p-49));
    CHECK(squared_threshold_lower(HUGE_VAL) == 0x1p1020);
    CHECK(squared_threshold_lower(0.0) == 0.0);
    CHECK(squared_threshold_lower(-1.0) == 0.0);
    CHECK(squared_threshold_lower(std::numeric_limits<double>::quiet_NaN()) == 0.0);
}

TEST_CASE("An expiry is not above the path length it is made of, nor far below", "[relocation][rounding][tight]") {
    REQUIRE(for_all("of any magnitude", [](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 500; ++i) {
            const double x = positive(random, -1074, 1000);
            const double e = Expiry::lower(x).path_length();
            if (!(e <= x && e >= 0.0)) RC_FAIL("above: " + as_code(x));
            if (x >= 0x1p-1000 && !(e > x * (1.0 - 0x1p-20))) RC_FAIL("far below: " + as_code(x));
            const double y = positive(random, -1074, 1000);
            if (x <= y && Expiry::lower(y) < Expiry::lower(x)) RC_FAIL("order: " + as_code(x) + ", " + as_code(y));
        }
    }));
    CHECK(Expiry::lower(1.0 + 0x1p-20).path_length() == 1.0 + 0x1p-20);
    CHECK(Expiry::lower(1.0 + 0x1p-20 - 0x1p-52).path_length() == 1.0);
    CHECK(Expiry::lower(0.0) == Expiry{});
    CHECK(Expiry::lower(-1.0) == Expiry{});
    CHECK(Expiry::lower(-HUGE_VAL) == Expiry{});
    CHECK(Expiry::never().path_length() == HUGE_VAL);
    CHECK(Expiry::lower(std::numeric_limits<double>::max()) < Expiry::never());
}
