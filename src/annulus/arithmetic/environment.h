// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfloat>
#include <string>

#if defined(__FAST_MATH__)
#error "annulus: -ffast-math breaks every error bound in this library; compile without it"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "annulus: the error bounds assume that double operations are rounded to double (FLT_EVAL_METHOD == 0)"
#endif

namespace annulus {

/// Empty when the floating-point unit of the calling thread does what the proofs assume, else what it does wrong.
///
/// Looked at: rounding to nearest is in force; directed rounding of 1/3 works at run time; a*b + c is not contracted
/// into a fused multiply-add in code compiled with the library's flags; subnormals are neither flushed nor read as
/// zero. Costs about a hundred nanoseconds.
[[nodiscard]] std::string environment_fault();

/// Throws Error(environment) with the words of environment_fault() unless that is empty.
void require_sound_environment();

}  // namespace annulus
