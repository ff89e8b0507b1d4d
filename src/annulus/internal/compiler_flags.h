// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Refuses flags of compilers that break the arithmetic.
#include <annulus/types.h>

#include <cfloat>

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
