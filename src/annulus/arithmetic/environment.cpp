// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/environment.h>

#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/error.h>

#include <cfenv>
#include <limits>

namespace annulus::inline v1 {

namespace {

/// A value that is opaque to the optimiser.
double opaque(double x) {
    volatile double v = x;
    return v;
}

bool fused() {
    // (1+e)(1-e) = 1 - e^2 rounds to 1, so the sum is 0 unless the product is kept exact.
    const double e = opaque(0x1p-30);
    const double a = opaque(1.0) + e;
    const double b = opaque(1.0) - e;
    const double c = opaque(-1.0);
    return opaque(a * b + c) != 0.0;
}

bool reassociated() {
    const double a = opaque(1.0);
    const double b = opaque(0x1p-60);
    return opaque((a + b) - a) != 0.0;
}

bool nan_unseen() {
    const double nan = opaque(std::numeric_limits<double>::quiet_NaN());
    return nan == nan || !(nan != nan) || nan <= 1.0;
}

bool directed_rounding_works() {
    // The operands are read again under each guard: compilers do not model rounding modes and would divide once.
    double up = 0.0;
    double down = 0.0;
    {
        const Rounding_guard guard(FE_UPWARD);
        up = opaque(opaque(1.0) / opaque(3.0));
    }
    {
        const Rounding_guard guard(FE_DOWNWARD);
        down = opaque(opaque(1.0) / opaque(3.0));
    }
    return down < up && std::fegetround() == FE_TONEAREST;
}

bool subnormals_flushed() {
    const double smallest = opaque(std::numeric_limits<double>::min());
    const double half = opaque(smallest * opaque(0.5));
    return !(half > 0.0) || opaque(half * opaque(2.0)) != smallest;
}

}  // namespace

std::string environment_fault() {
    if (std::fegetround() != FE_TONEAREST) return "the rounding mode is not round-to-nearest";
    if (!directed_rounding_works()) return "directed rounding has no effect";
    if (fused()) return "a*b + c is contracted into a fused multiply-add (compile with -ffp-contract=off)";
    if (reassociated()) return "sums are reassociated (compile without -fassociative-math)";
    if (nan_unseen()) return "a NaN compares as a number (compile without -ffinite-math-only)";
    if (subnormals_flushed())
        return "subnormal numbers are flushed to zero: FTZ or DAZ is set in this thread, as a library linked with "
               "-ffast-math does when it is loaded; clear both before calling annulus (on x86: "
               "_mm_setcsr(_mm_getcsr() & ~0x8040u); on arm64: bit 24, FZ, of FPCR)";
    return {};
}

void require_sound_environment() {
    if (const std::string fault = environment_fault(); !fault.empty())
        throw Error(Error_code::environment, "floating-point environment: " + fault);
}

}  // namespace annulus::inline v1
