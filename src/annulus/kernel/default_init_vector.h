// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Leaves elements of trivial types uninitialised when a vector grows, which saves a pass over memory.
template <class T>
class Default_init_allocator : public std::allocator<T> {
  public:
    template <class U>
    struct rebind {
        using other = Default_init_allocator<U>;
    };
    Default_init_allocator() = default;
    template <class U>
    explicit Default_init_allocator(const Default_init_allocator<U>&) noexcept {}

    template <class U>
    void construct(U* p) noexcept {
        ::new (static_cast<void*>(p)) U;
    }
    template <class U, class... Arguments>
    void construct(U* p, Arguments&&... arguments) {
        std::construct_at(p, std::forward<Arguments>(arguments)...);
    }
};

/// A vector whose elements have no value until one is written. T must be trivially copyable.
template <class T>
using Default_init_vector = std::vector<T, Default_init_allocator<T>>;

}  // namespace annulus::inline v1
