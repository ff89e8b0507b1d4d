// SPDX-License-Identifier: GPL-3.0-or-later
// The tail of the interval stage on intervals so wide that each end shows its direction of rounding.
#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/predicate/interval_stage.h>

#include <support/arbitrary.h>
#include <support/catch.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace annulus;

namespace {

// From memory and never inlined: see Rounding_guard.
[[gnu::noinline]] void roots(const Interval& x, const Interval& y, double& r) { r = detail::roots_upper(x, y); }
[[gnu::noinline]] void quotient(const double& x, const double& y, double& r) { r = detail::quotient_lower(x, y); }
[[gnu::noinline]] void quotients(const std::vector<double>& x, const std::vector<double>& y, std::vector<double>& q) {
    for (std::size_t i = 0; i < x.size(); ++i) quotient(x[i], y[i], q[i]);
}
[[gnu::noinline]] void tight(const Interval& d, double& lower, bool& is) {
    is = detail::quotient_lower_in_slack(d, 4.0, 4.0, lower);
}
[[gnu::noinline]] void unscaled(const double& x, const detail::Scale& s, double& r) {
    r = detail::unscaled_lower(x, s);
}

}  // namespace

TEST_CASE("each end of the interval stage's tail is the safe one", "[certificate]") {
    const Interval x(1.0, 4.0), y(9.0, 16.0), two(2.0), wide(1.0, 2.0), narrow(1.0, 1.0 + 0x1p-20), around(-1.0, 1.0);
    const double one = 1.0, three = 3.0, smallest = 0x1p-1074;
    const detail::Scale scale{0x1p1, 0x1p0};
    double sum = 0.0, root_of_two = 0.0, third = 0.0, lower = 0.0, lower_narrow = 0.0, least = 0.0;
    bool is_tight = true, narrow_is_tight = false;
    {
        const Rounding_guard guard(FE_UPWARD);
        roots(x, y, sum);
        roots(two, two, root_of_two);
        quotient(one, three, third);
        tight(wide, lower, is_tight);
        tight(narrow, lower_narrow, narrow_is_tight);
        unscaled(smallest, scale, least);
    }
    CHECK(sum == 6.0);
    CHECK(root_of_two > 2.828427124746190);
    CHECK(third == 0x1.5555555555555p-2);
    CHECK(lower == 0.25);
    CHECK_FALSE(is_tight);
    CHECK(lower_narrow == 0.25);
    CHECK(narrow_is_tight);
    CHECK(least == 0.0);
    Certificate_value v;
    CHECK_FALSE(detail::interval_sign(around, v));
    CHECK(detail::interval_sign(x, v));
    CHECK(v.sign == 1);
}

TEST_CASE("a quotient's lower bound is the largest double not above it", "[certificate]") {
    testing::Random random(run_seed());
    constexpr std::size_t n = 100000;
    std::vector<double> x(n), y(n), q(n);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = std::ldexp(testing::between(random, 0, 1), testing::integer(random, -300, 300));
        y[i] = std::ldexp(testing::between(random, 0.5, 1), testing::integer(random, -300, 300));
    }
    {
        const Rounding_guard guard(FE_UPWARD);
        quotients(x, y, q);
    }
    // The residue of a product and a sum in one rounding has the sign of the true one.
    for (std::size_t i = 0; i < n; ++i) {
        const bool below = std::fma(q[i], y[i], -x[i]) <= 0;
        const bool next_above =
            std::fma(std::nextafter(q[i], std::numeric_limits<double>::infinity()), y[i], -x[i]) > 0;
        if (!below || !next_above) FAIL(x[i] << " / " << y[i]);
    }
    SUCCEED();
}
