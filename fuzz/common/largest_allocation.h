// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// How much memory a reader takes.

#include <algorithm>
#include <cstddef>
#include <cstdlib>

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define ANNULUS_COUNTS_MEMORY
#endif
#endif
#ifdef ANNULUS_COUNTS_MEMORY
#include <sanitizer/allocator_interface.h>
#endif

namespace annulus::fuzz {

/// Bytes allocated since the last reset, now and at the most. Always 0 without the sanitizer.
struct Memory {
    static inline std::size_t now = 0, peak = 0;
    static void reset() { now = peak = 0; }
#ifdef ANNULUS_COUNTS_MEMORY
    static void taken(const volatile void*, std::size_t size) {
        now += size;
        peak = std::max(peak, now);
    }
    static void given(const volatile void* p) {
        if (p == nullptr) return;
        now -= std::min(now, __sanitizer_get_allocated_size(p));
    }
    static inline const int installed = __sanitizer_install_malloc_and_free_hooks(taken, given);
#endif
};

}  // namespace annulus::fuzz
