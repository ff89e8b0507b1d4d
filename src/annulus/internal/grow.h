// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// Resizes an array that grows a little now and then. Reserves a thirty-second part more than is needed, where
/// std::vector doubles. The capacity stays within 33/32 of the size, and the array is copied O(log n) times.
template <class T>
void grow(std::vector<T>& x, std::size_t size, const T& value = T()) {
    if (size > x.capacity() && x.capacity() > 0) x.reserve(size + size / 32);
    x.resize(size, value);
}

/// Frees the memory of an array, which `x = {}` does not do.
template <class T>
void release(std::vector<T>& x) noexcept {
    std::vector<T>().swap(x);
}

}  // namespace annulus::inline v1
