// SPDX-License-Identifier: GPL-3.0-or-later
// The interval policy: its enclosures are checked with rational numbers.

#include <support/arbitrary.h>
#include <support/catch.h>

#include <annulus/arithmetic/interval.h>
#include <annulus/arithmetic/rounding_guard.h>

#include <gmpxx.h>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

// Operations on operands in memory, never inlined: see Rounding_guard.
[[gnu::noinline]] void add(const Interval& x, const Interval& y, Interval& r) { r = x + y; }
[[gnu::noinline]] void subtract(const Interval& x, const Interval& y, Interval& r) { r = x - y; }
[[gnu::noinline]] void multiply(const Interval& x, const Interval& y, Interval& r) { r = x * y; }
[[gnu::noinline]] void divide(const Interval& x, const Interval& y, Interval& r) { r = x / y; }
[[gnu::noinline]] void square(const Interval& x, Interval& r) { r = squared(x); }
[[gnu::noinline]] void root(const Interval& x, Interval& r) { r = sqrt(x); }
[[gnu::noinline]] void greater(const Interval& x, const Interval& y, Interval& r) { r = max(x, y); }
[[gnu::noinline]] void differ(double a, double b, double scale, Interval& r) { r = scaled_difference(a, b, scale); }

/// lower <= x <= upper, where an end may be infinite.
bool encloses(const Interval& i, const mpq_class& x) {
    if (std::isnan(i.lower()) || std::isnan(i.upper())) return false;
    const bool above = std::isinf(i.lower()) ? i.lower() < 0 : mpq_class(i.lower()) <= x;
    const bool below = std::isinf(i.upper()) ? i.upper() > 0 : mpq_class(i.upper()) >= x;
    return above && below;
}

/// The ends are equal or neighbours.
bool is_narrow(const Interval& i) { return i.upper() <= std::nextafter(i.lower(), HUGE_VAL); }

/// A number of moderate or any magnitude.
double number(Random& random) {
    return random() % 2 == 0 ? std::ldexp(between(random, -1, 1), integer(random, -30, 30)) : any_in_domain(random);
}

struct Sampled {
    Interval interval;
    std::vector<double> inside;
};

Sampled sampled(Random& random) {
    double low = number(random);
    double high = random() % 3 == 0 ? low : random() % 2 == 0 ? ulp_noise(random, low, 5) : number(random);
    if (low > high) std::swap(low, high);
    Sampled s{Interval(low, high), {low, high}};
    const double middle = 0.5 * low + 0.5 * high;
    if (low <= middle && middle <= high) s.inside.push_back(middle);
    if (low <= 0 && 0 <= high) s.inside.push_back(0.0);
    return s;
}

std::string as_code(const Interval& i) {
    return "Interval(" + annulus::testing::as_code(i.lower()) + ", " + annulus::testing::as_code(i.upper()) + ")";
}

}  // namespace

#define ENCLOSES(result, exact, ...)                                                                     \
    do {                                                                                                 \
        const mpq_class exact_value = exact;                                                             \
        if (!encloses(result, exact_value)) RC_FAIL(#result " " #exact ": " + std::string(__VA_ARGS__)); \
    } while (false)

TEST_CASE("interval operations enclose the exact results", "[arithmetic]") {
    REQUIRE(for_all("of every pair of numbers inside", [](const Seed& seed) {
        Random random = seed.random();
        for (int k = 0; k < 50; ++k) {
            const Sampled x = sampled(random), y = sampled(random);
            const bool divisible = y.interval.lower() > 0 || y.interval.upper() < 0;
            Interval sum, difference, product, ratio, power, most;
            {
                const Rounding_guard guard(FE_UPWARD);
                add(x.interval, y.interval, sum);
                subtract(x.interval, y.interval, difference);
                multiply(x.interval, y.interval, product);
                if (divisible) divide(x.interval, y.interval, ratio);
                square(x.interval, power);
                greater(x.interval, y.interval, most);
            }
            const std::string text = as_code(x.interval) + ", " + as_code(y.interval);
            if (!(power.lower() >= 0)) RC_FAIL("a negative square: " + text);
            for (const double i : x.inside) {
                const mpq_class p(i);
                ENCLOSES(power, p * p, text);
                for (const double j : y.inside) {
                    const mpq_class q(j);
                    ENCLOSES(sum, p + q, text);
                    ENCLOSES(difference, p - q, text);
                    ENCLOSES(product, p * q, text);
                    if (divisible) ENCLOSES(ratio, p / q, text);
                    ENCLOSES(most, std::max(p, q), text);
                }
            }
        }
    }));
}

TEST_CASE("an operation on two numbers gives neighbouring ends", "[arithmetic]") {
    REQUIRE(for_all("sum, difference, product, quotient, square and root", [](const Seed& seed) {
        Random random = seed.random();
        for (int k = 0; k < 50; ++k) {
            const double a = number(random), b = number(random);
            const Interval x(a), y(b), positive(std::fabs(a));
            Interval sum, difference, product, ratio(0.0), power, square_root;
            {
                const Rounding_guard guard(FE_UPWARD);
                add(x, y, sum);
                subtract(x, y, difference);
                multiply(x, y, product);
                if (b != 0.0) divide(x, y, ratio);
                square(x, power);
                root(positive, square_root);
            }
            for (const Interval& r : {sum, difference, product, ratio, power, square_root})
                if (!is_narrow(r)) RC_FAIL(as_code(x) + ", " + as_code(y) + " -> " + as_code(r));
            const mpq_class low(square_root.lower()), high(square_root.upper()), truth(std::fabs(a));
            if (!(low * low <= truth && truth <= high * high)) RC_FAIL("root of " + as_code(positive));
        }
    }));
}

TEST_CASE("the root of an interval encloses the roots of its ends", "[arithmetic]") {
    REQUIRE(for_all("compared by squares", [](const Seed& seed) {
        Random random = seed.random();
        for (int k = 0; k < 50; ++k) {
            double low = std::fabs(number(random)), high = std::fabs(number(random));
            if (low > high) std::swap(low, high);
            const Interval x(low, high);
            Interval r;
            {
                const Rounding_guard guard(FE_UPWARD);
                root(x, r);
            }
            const mpq_class least(r.lower()), most(r.upper());
            if (!(least * least <= mpq_class(low) && most * most >= mpq_class(high))) RC_FAIL(as_code(x));
        }
    }));
}

TEST_CASE("scaled differences enclose the exact ones", "[arithmetic]") {
    REQUIRE(for_all("with any power of two that keeps them in range", [](const Seed& seed) {
        Random random = seed.random();
        for (int k = 0; k < 50; ++k) {
            const double a = any_in_domain(random),
                         b = random() % 2 == 0 ? ulp_noise(random, a, 3) : any_in_domain(random);
            const double scale = std::ldexp(1.0, integer(random, -500, 500));
            Interval r;
            {
                const Rounding_guard guard(FE_UPWARD);
                differ(a, b, scale, r);
            }
            const mpq_class truth = (mpq_class(a) - mpq_class(b)) * mpq_class(scale);
            if (!encloses(r, truth))
                RC_FAIL(annulus::testing::as_code(a) + ", " + annulus::testing::as_code(b) + ", " +
                        annulus::testing::as_code(scale));
        }
    }));
}

TEST_CASE("intervals that are known", "[arithmetic]") {
    Interval third, product, square_of_mixed, square_of_negative, sum;
    {
        const Rounding_guard guard(FE_UPWARD);
        divide(Interval(1.0), Interval(3.0), third);
        multiply(third, Interval(3.0), product);
        square(Interval(-1.0, 2.0), square_of_mixed);
        square(Interval(-3.0, -2.0), square_of_negative);
        add(Interval(1.0), Interval(0x1p-80), sum);
    }
    CHECK(third.lower() < third.upper());
    CHECK(std::nextafter(third.lower(), 1.0) == third.upper());
    CHECK(encloses(third, mpq_class(1, 3)));
    CHECK(product.lower() < 1.0);
    CHECK(product.upper() >= 1.0);
    CHECK(square_of_mixed.lower() == 0.0);
    CHECK(square_of_mixed.upper() == 4.0);
    CHECK(square_of_negative.lower() == 4.0);
    CHECK(square_of_negative.upper() == 9.0);
    CHECK(sum.lower() == 1.0);
    CHECK(sum.upper() == 1.0 + 0x1p-52);
    CHECK(squared(-1.5) == 2.25);
}
