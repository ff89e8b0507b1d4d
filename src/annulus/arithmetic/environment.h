// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cfloat>
#include <string>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__)
#error "annulus: -ffast-math and its parts break every error bound in this library; compile without them"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0
#error "annulus: with -ffinite-math-only a NaN passes every test for one; compile without it"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "annulus: the error bounds assume that double operations are rounded to double (FLT_EVAL_METHOD == 0)"
#endif

static_assert(0.1 != static_cast<double>(0.1F),
              "annulus: -fsingle-precision-constant rounds constants to float; compile without it");

namespace annulus::inline v1 {

/// Empty when the floating-point unit of the calling thread behaves as the proofs assume; otherwise a description of
/// the first difference.
///
/// Checks that rounding to nearest is in force; that directed rounding of 1/3 works at run time; that in code compiled
/// with the library's flags a*b + c is not contracted into a fused multiply-add, (a + b) - a is not simplified to b,
/// and a NaN is recognised; and that subnormals are neither flushed nor read as zero. Costs about a hundred
/// nanoseconds.
[[nodiscard]] std::string environment_fault();

/// Throws Error(environment) with the text of environment_fault() unless that is empty.
void require_sound_environment();

}  // namespace annulus::inline v1
