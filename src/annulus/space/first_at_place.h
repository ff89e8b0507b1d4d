// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// For each point, the index of the first point at the same position: its own index where no earlier point is there.
/// O(n log n).
template <int d>
[[nodiscard]] std::vector<std::size_t> first_at_place(std::span<const Coordinates<d>> x) {
    std::vector<std::size_t> order(x.size()), first(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&x](std::size_t i, std::size_t j) { return x[i] != x[j] ? x[i] < x[j] : i < j; });
    for (std::size_t k = 0; k < order.size(); ++k)
        first[order[k]] = k > 0 && x[order[k]] == x[order[k - 1]] ? first[order[k - 1]] : order[k];
    return first;
}

}  // namespace annulus::inline v1
