// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/compiler_flags.h>

#include <string>

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
