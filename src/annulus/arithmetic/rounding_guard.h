// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cfenv>

namespace annulus::inline v1 {

/// Sets the rounding mode of the calling thread and restores the previous one at the end of the scope.
///
/// The mode belongs to the thread: a guard has no effect on workers started inside its scope. Use one guard for a
/// batch of interval evaluations, because changing the mode costs more than an evaluation:
///
///     {
///         const Rounding_guard upward(FE_UPWARD);
///         for (std::size_t i = 0; i < n; ++i) evaluate(x[i], out[i]);  // never inlined, reads x from memory
///     }  // rounding as before: compare, and round to nearest, only here
///
/// Compilers do not model the rounding mode: they may move arithmetic on values held in registers across the call that
/// sets it, even with -frounding-math. Both ends of the scope are therefore memory barriers. Computations under a
/// guard must read their operands from memory, in functions that are not inlined into the guarded scope.
class Rounding_guard {
  public:
    explicit Rounding_guard(int mode) noexcept : previous_(std::fegetround()) {
        std::fesetround(mode);
        asm volatile("" ::: "memory");
    }
    ~Rounding_guard() {
        asm volatile("" ::: "memory");
        std::fesetround(previous_);
    }
    Rounding_guard(const Rounding_guard&) = delete;
    Rounding_guard& operator=(const Rounding_guard&) = delete;

  private:
    int previous_;
};

}  // namespace annulus::inline v1
