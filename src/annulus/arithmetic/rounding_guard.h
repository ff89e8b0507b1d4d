// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cfenv>

namespace annulus {

/// Sets the rounding mode of the calling thread and puts the previous one back at the end of the scope.
///
/// The mode belongs to the thread: a guard here does nothing for workers started inside its scope. One guard goes
/// around a batch of interval evaluations, because changing the mode costs more than an evaluation.
///
/// Compilers do not model the rounding mode: they may move arithmetic on values held in registers across the call
/// that sets it, even with -frounding-math. Both ends of the scope are therefore barriers for memory, and what is
/// computed under a guard must be computed from memory, in functions that are not inlined into the guarded scope.
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

}  // namespace annulus
