// SPDX-License-Identifier: GPL-3.0-or-later
// The upper half of a double: its accuracy, and on which side of the truth it is.

#include <support/arbitrary.h>
#include <support/catch.h>

#include <annulus/arithmetic/truncated_double.h>

#include <bit>
#include <cmath>
#include <limits>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Any double but a NaN.
double any_double(Random& random) {
    for (;;) {
        const double x = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
        if (!std::isnan(x)) return x;
    }
}

}  // namespace

TEST_CASE("The upper half of a double is not above it and nearly as large", "[arithmetic]") {
    REQUIRE(for_all([](const Seed& seed) {
        Random random = seed.random();
        for (int i = 0; i < 1000; ++i) {
            const double x = any_double(random);
            const double half = Truncated_double::truncated(x).value();
            RC_ASSERT(std::fabs(half) <= std::fabs(x));
            RC_ASSERT(std::signbit(half) == std::signbit(x));
            if (std::fabs(x) >= std::numeric_limits<double>::min() && std::isfinite(x))
                RC_ASSERT(std::fabs(half) > std::fabs(x) * (1.0 - 0x1p-20));
            RC_ASSERT(Truncated_double::truncated(half).value() == half);
            const double lower = Truncated_double::lower(x).value();
            RC_ASSERT(lower == (x > 0.0 ? half : 0.0));
            const double y = any_double(random);
            if (x >= 0.0 && y >= 0.0)
                RC_ASSERT((Truncated_double::lower(x).bits() < Truncated_double::lower(y).bits()) ==
                          (Truncated_double::lower(x).value() < Truncated_double::lower(y).value()));
        }
    }));
    CHECK(Truncated_double::lower(-1.0).value() == 0.0);
    CHECK(Truncated_double::lower(std::numeric_limits<double>::quiet_NaN()).value() == 0.0);
    CHECK(Truncated_double::lower(1.0).value() == 1.0);
    CHECK(Truncated_double::lower(std::nextafter(1.0, 0.0)).value() < 1.0);
    CHECK(std::isinf(Truncated_double::infinity().value()));
    CHECK(Truncated_double::lower(std::numeric_limits<double>::max()).value() <
          std::numeric_limits<double>::infinity());
}
