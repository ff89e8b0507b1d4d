// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
// g++'s own intrinsics for AVX-512 start from uninitialised registers, and g++ warns about these where they are used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wuninitialized"
#endif
#include <experimental/simd>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

namespace annulus::inline v1 {

/// Several doubles side by side, as many as a register of the target holds: 2 on the x86-64 baseline. Each lane is
/// rounded as a single double would be.
using Lanes = std::experimental::native_simd<double>;

}  // namespace annulus::inline v1
