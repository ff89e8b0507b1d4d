// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// Sorts a list and removes duplicates. O(n log n).
template <class T>
void sort_unique(std::vector<T>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
}

/// The same for indices below a bound. Many indices are marked, not compared: O(n + bound / 64).
template <class Tag>
void sort_unique(std::vector<Typed_index<Tag>>& list, Typed_index<Tag> bound) {
    constexpr std::size_t bits = 64;
    if (bits * list.size() < bound.offset()) return sort_unique(list);
    std::vector<std::uint64_t> marks((bound.offset() + bits - 1) / bits);
    for (const Typed_index<Tag> i : list) marks[i.offset() / bits] |= std::uint64_t{1} << (i.offset() % bits);
    list.clear();
    for (std::size_t k = 0; k < marks.size(); ++k)
        for (std::uint64_t left = marks[k]; left != 0; left &= left - 1)
            list.push_back(
                Typed_index<Tag>(static_cast<Index>(bits * k + static_cast<std::size_t>(std::countr_zero(left)))));
}

}  // namespace annulus::inline v1
