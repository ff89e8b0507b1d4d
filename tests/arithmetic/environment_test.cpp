// SPDX-License-Identifier: GPL-3.0-or-later
// The rounding guard, and the checks of the environment before anything is certified.
//
// Contraction into fused multiply-adds cannot be switched on at run time: to see environment_fault() report it, compile
// src/annulus/arithmetic/environment.cpp with -mfma -ffp-contract=fast.

#include <annulus/arithmetic/domain.h>
#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/error.h>
#include <annulus/types.h>

#include <support/catch.h>

#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <thread>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

using namespace annulus;

namespace {

[[gnu::noinline]] double third() {
    volatile double one = 1.0, three = 3.0;
    return one / three;
}

#if defined(__x86_64__)
/// Sets bits of the control register and restores the register.
class Control_bits {
  public:
    explicit Control_bits(unsigned bits) : previous_(_mm_getcsr()) { _mm_setcsr(previous_ | bits); }
    ~Control_bits() { _mm_setcsr(previous_); }
    Control_bits(const Control_bits&) = delete;
    Control_bits& operator=(const Control_bits&) = delete;

  private:
    unsigned previous_;
};
constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
#endif

}  // namespace

TEST_CASE("a rounding guard sets a mode and puts the previous one back", "[arithmetic]") {
    REQUIRE(std::fegetround() == FE_TONEAREST);
    const double nearest = third();
    {
        const Rounding_guard upward(FE_UPWARD);
        CHECK(std::fegetround() == FE_UPWARD);
        const double up = third();
        {
            const Rounding_guard downward(FE_DOWNWARD);
            CHECK(std::fegetround() == FE_DOWNWARD);
            const double down = third();
            CHECK(down < up);
            CHECK(std::nextafter(down, 1.0) == up);
            {
                const Rounding_guard again(FE_TONEAREST);
                CHECK(third() == nearest);
            }
            CHECK(std::fegetround() == FE_DOWNWARD);
        }
        CHECK(std::fegetround() == FE_UPWARD);
        CHECK(third() == up);
    }
    CHECK(std::fegetround() == FE_TONEAREST);
    CHECK(third() == nearest);
}

TEST_CASE("a rounding guard puts the mode back when an exception passes", "[arithmetic]") {
    try {
        const Rounding_guard upward(FE_UPWARD);
        throw Error(Error_code::usage, "thrown under a guard");
    } catch (const Error& error) {
        CHECK(error.code() == Error_code::usage);
        CHECK(std::fegetround() == FE_TONEAREST);
    }
}

TEST_CASE("a rounding guard is of its thread alone", "[arithmetic]") {
    const Rounding_guard upward(FE_UPWARD);
    int inside = -1, after = -1;
    std::thread([&] {
        {
            const Rounding_guard downward(FE_DOWNWARD);
            inside = std::fegetround();
        }
        after = std::fegetround();
    }).join();
    CHECK(inside == FE_DOWNWARD);
    CHECK(after != FE_DOWNWARD);
    CHECK(std::fegetround() == FE_UPWARD);
}

TEST_CASE("the environment of a test is sound", "[arithmetic]") {
    CHECK(environment_fault() == "");
    CHECK_NOTHROW(require_sound_environment());
    CHECK(std::fegetround() == FE_TONEAREST);
    std::string in_a_thread = "not run";
    std::thread([&] { in_a_thread = environment_fault(); }).join();
    CHECK(in_a_thread == "");
}

TEST_CASE("a wrong rounding mode is a fault, and is left as it was", "[arithmetic]") {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        std::string fault;
        std::optional<Error_code> code;
        int left = -1;
        {
            const Rounding_guard guard(mode);
            fault = environment_fault();
            try {
                require_sound_environment();
            } catch (const Error& error) {
                code = error.code();
            }
            left = std::fegetround();
        }
        INFO("mode " << mode);
        CHECK(fault.find("rounding mode") != std::string::npos);
        CHECK(code == Error_code::environment);
        CHECK(left == mode);
    }
    CHECK(environment_fault() == "");
}

#if defined(__x86_64__)
TEST_CASE("subnormals flushed or read as zero are a fault", "[arithmetic]") {
    for (const unsigned bits : {flush_to_zero, denormals_are_zero, flush_to_zero | denormals_are_zero}) {
        std::string fault;
        {
            const Control_bits guard(bits);
            fault = environment_fault();
        }
        INFO("control bits " << bits);
        CHECK(fault.find("subnormal") != std::string::npos);
        CHECK(fault.find("FTZ or DAZ is set in this thread") != std::string::npos);
        CHECK(environment_fault() == "");
    }
}
#endif

TEST_CASE("the domain is every number of magnitude at most 2^500", "[arithmetic]") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double sign : {1.0, -1.0}) {
        for (const double x : {0.0, 0x1p-1074, 0x1p-1022, 1.0, std::nextafter(0x1p500, 0.0), 0x1p500}) {
            INFO("x = " << sign * x);
            CHECK(in_domain(sign * x));
        }
        for (const double x : {std::nextafter(0x1p500, infinity), 0x1p501, 0x1.fffffffffffffp+1023, infinity, nan}) {
            INFO("x = " << sign * x);
            CHECK(!in_domain(sign * x));
        }
    }
    CHECK(in_domain(Coordinates<2>{0x1p500, -0x1p500}));
    CHECK(in_domain(Coordinates<3>{-0.0, 0x1p-1074, 0.0}));
    CHECK(!in_domain(Coordinates<2>{0.0, nan}));
    CHECK(!in_domain(Coordinates<2>{-infinity, 0.0}));
    CHECK(!in_domain(Coordinates<3>{0.0, 0.0, 0x1p501}));
    // The purpose of the limit: squared distances stay finite.
    const double d = 0x1p500 - -0x1p500;
    CHECK(std::isfinite(d * d + d * d + d * d));
}

TEST_CASE("stage counts", "[arithmetic]") {
    Stage_counts counts;
    CHECK(counts.total() == 0);
    counts.count(Stage::filter);
    counts.count(Stage::filter);
    counts.count(Stage::filter);
    counts.count(Stage::interval);
    counts.count(Stage::interval);
    counts.count(Stage::exact);
    CHECK(counts == Stage_counts{3, 2, 1});
    CHECK(counts.total() == 6);
    Stage_counts sum{10, 20, 30};
    sum += counts;
    CHECK(sum == Stage_counts{13, 22, 31});
    CHECK(sum.total() == 66);
    CHECK(!(sum == counts));
}
