// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Allocations that fail on purpose. The whole test program allocates through the operators of failing_new.cpp, which
// are malloc and free unless the same thread has a Failing_new. GMP and MPFR call malloc directly: they end the process
// where it fails, which cannot be tested here.

#include <cstdint>
#include <new>

namespace annulus::testing {

enum class Memory {
    short_once,     ///< one allocation fails, those after it succeed
    short_for_good  ///< that one and all after it fail, until the Failing_new ends
};

/// While it exists, the n-th allocation of this thread through operator new fails, counted from 0. One object at a
/// time.
class Failing_new {
  public:
    explicit Failing_new(std::uint64_t n, Memory memory = Memory::short_once) noexcept;
    ~Failing_new();
    Failing_new(const Failing_new&) = delete;
    Failing_new& operator=(const Failing_new&) = delete;

    /// Whether an allocation has failed.
    [[nodiscard]] static bool failed() noexcept;
    /// The number of allocations since construction, including failed ones.
    [[nodiscard]] static std::uint64_t count() noexcept;
    /// Their size in bytes.
    [[nodiscard]] static std::uint64_t bytes() noexcept;
};

/// The outcome of a call whose n-th allocation failed.
enum class Starved {
    done,    ///< it made fewer allocations, and returned
    coped,   ///< it managed without this memory, and returned
    refused  ///< it threw bad_alloc
};

/// Calls f, and passes on all its exceptions except bad_alloc.
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
