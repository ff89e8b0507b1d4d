// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/experiment/rounding.h>

#include <support/catch.h>
#include <support/repeats.h>

#include <gmpxx.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

using namespace annulus;

TEST_CASE("Decimals are those of printf and strtod, multiples of a spacing are the nearest") {
    std::mt19937_64 random(1);
    for (int i = 0; i < repeats(20000); ++i) {
        const double x = (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5) *
                         std::pow(10.0, static_cast<double>(random() % 12) - 4);
        CAPTURE(x);
        const int digits = static_cast<int>(random() % 18);
        char text[100];
        std::snprintf(text, sizeof text, "%.*f", digits, x);
        REQUIRE(rounded(x, *rounding_named("decimal:" + std::to_string(digits))) == std::strtod(text, nullptr));
        REQUIRE(rounded(x, *rounding_named("float")) == static_cast<double>(static_cast<float>(x)));
        REQUIRE(rounded(x, *rounding_named("double")) == x);
        // In rational numbers: at most half a spacing, and a rounding, away.
        const double h = 0.001;
        const mpq_class off = abs(mpq_class(rounded(x, *rounding_named("grid:0.001"))) - mpq_class(x));
        REQUIRE(off <= mpq_class(h) / 2 + abs(mpq_class(x)) * mpq_class(0x1p-51));
    }
}

TEST_CASE("What is no rounding has no name") {
    for (const char* word : {"", "decimal", "decimal:", "decimal:18", "decimal:-1", "decimal:3x", "grid:0", "grid:-1",
                             "grid:nan", "grid:inf", "grid:", "half", "Double", "float:3"})
        CHECK_FALSE(rounding_named(word));
}

TEST_CASE("What is too large for a float is refused, and not infinite") {
    const Rounding single = *rounding_named("float");
    CHECK(rounded(3.4028234e38, single) < 3.5e38);
    for (const double x : {3.5e38, -1e300}) CHECK_THROWS_AS(rounded(x, single), Error);
}
