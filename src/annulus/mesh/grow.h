// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cstddef>
#include <vector>

namespace annulus {

/// Makes an array that grows a little now and then longer: by a thirty-second part beyond what is asked for, where
/// std::vector takes as much again. What it is given stays within 33/32 of what it needs, and it is copied O(log n)
/// times.
template <class T>
void grow(std::vector<T>& x, std::size_t size, const T& value = T()) {
    if (size > x.capacity() && x.capacity() > 0) x.reserve(size + size / 32);
    x.resize(size, value);
}

/// Gives the memory of an array back, which `x = {}` does not.
template <class T>
void release(std::vector<T>& x) noexcept {
    std::vector<T>().swap(x);
}

}  // namespace annulus
