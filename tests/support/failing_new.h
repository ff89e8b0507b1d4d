// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Memory that runs out at a chosen allocation. The whole test program allocates through the operators of
// failing_new.cpp, which are malloc and free unless a Failing_new of the same thread lives. GMP and MPFR call malloc
// themselves and are not reached: they end the process where it fails, which nothing here can test.

#include <cstdint>
#include <new>

namespace annulus::testing {

enum class Memory {
    short_once,     ///< one allocation fails, those after it succeed
    short_for_good  ///< that one and all after it fail, until the Failing_new ends
};

/// While it lives, the n-th allocation of this thread through operator new fails, counted from 0. One at a time.
class Failing_new {
  public:
    explicit Failing_new(std::uint64_t n, Memory memory = Memory::short_once) noexcept;
    ~Failing_new();
    Failing_new(const Failing_new&) = delete;
    Failing_new& operator=(const Failing_new&) = delete;

    /// An allocation has failed.
    [[nodiscard]] static bool failed() noexcept;
    /// Allocations since it began, failed ones included.
    [[nodiscard]] static std::uint64_t count() noexcept;
    /// What they asked for, in bytes.
    [[nodiscard]] static std::uint64_t bytes() noexcept;
};

/// What became of a call whose n-th allocation failed.
enum class Starved {
    done,    ///< it made fewer allocations, and returned
    coped,   ///< it did without, and returned
    refused  ///< it threw bad_alloc
};

/// Calls f, and lets through whatever it throws but bad_alloc.
template <class F>
[[nodiscard]] Starved starve(std::uint64_t n, Memory memory, F&& f) {
    const Failing_new armed(n, memory);
    try {
        f();
    } catch (const std::bad_alloc&) {
        return Starved::refused;
    }
    return Failing_new::failed() ? Starved::coped : Starved::done;
}

}  // namespace annulus::testing
