// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/failing_new.h>

#include <cstddef>
#include <cstdlib>
#include <limits>

// CGAL's containers leak a block when there is no memory to enter it in their list of blocks. None of these leaks is in
// annulus.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:CGAL::Compact_container"; }

namespace annulus::testing {

namespace {

constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();

thread_local std::uint64_t fails_at = never;
thread_local std::uint64_t allocations = 0;
thread_local std::uint64_t asked_for = 0;
thread_local Memory memory_is = Memory::short_once;

bool is_refused(std::size_t size) noexcept {
    if (fails_at == never) return false;
    asked_for += size;
    const std::uint64_t k = allocations++;
    return k == fails_at || (k > fails_at && memory_is == Memory::short_for_good);
}

}  // namespace

Failing_new::Failing_new(std::uint64_t n, Memory memory) noexcept {
    fails_at = n;
    allocations = asked_for = 0;
    memory_is = memory;
}
Failing_new::~Failing_new() { fails_at = never; }
bool Failing_new::failed() noexcept { return fails_at != never && allocations > fails_at; }
std::uint64_t Failing_new::count() noexcept { return allocations; }
std::uint64_t Failing_new::bytes() noexcept { return asked_for; }

/// Null where memory is short.
static void* allocate(std::size_t size, std::size_t alignment) noexcept {
    if (is_refused(size)) return nullptr;
    if (size == 0) size = 1;
    if (alignment <= alignof(std::max_align_t)) return std::malloc(size);
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}
[[maybe_unused]] static void* allocate_or_throw(std::size_t size, std::size_t alignment) {
    if (void* const p = allocate(size, alignment)) return p;
    throw std::bad_alloc();
}

}  // namespace annulus::testing

// ThreadSanitizer's runtime defines these itself and tolerates no others; no memory test runs there.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define ANNULUS_KEEPS_NEW
#endif
#endif

#ifndef ANNULUS_KEEPS_NEW
// The array forms of the standard library call these.
void* operator new(std::size_t size) { return annulus::testing::allocate_or_throw(size, 0); }
void* operator new(std::size_t size, std::align_val_t a) {
    return annulus::testing::allocate_or_throw(size, static_cast<std::size_t>(a));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return annulus::testing::allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t a, const std::nothrow_t&) noexcept {
    return annulus::testing::allocate(size, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { std::free(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { std::free(p); }
#endif
