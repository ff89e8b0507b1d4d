// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bench {

/// Calls f(i, j) once for every pair of points at most about `reach` apart (and perhaps for some up to twice as far),
/// in an order that depends on the positions alone. O(n) where density is bounded; one grid of cells over the points'
/// box.
template <int d, class F>
void for_each_near_pair(const Points<d>& x, double reach, F f) {
    if (x.empty()) return;
    annulus::Coordinates<d> low = x[0];
    annulus::Coordinates<d> high = x[0];
    for (const auto& p : x)
        for (std::size_t k = 0; k < d; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    // A border of empty cells around, so that every cell has all its neighbours.
    std::size_t stride[d];
    std::size_t cells = 1;
    for (std::size_t k = 0; k < d; ++k) {
        stride[k] = cells;
        cells *= static_cast<std::size_t>((high[k] - low[k]) / reach) + 3;
    }
    const auto cell_of = [&](const annulus::Coordinates<d>& p) {
        std::size_t c = 0;
        for (std::size_t k = 0; k < d; ++k) c += stride[k] * (static_cast<std::size_t>((p[k] - low[k]) / reach) + 1);
        return c;
    };
    static thread_local std::vector<std::size_t> first;  // of the points of each cell, in `of`
    static thread_local std::vector<std::size_t> of;
    first.assign(cells + 1, 0);
    of.resize(x.size());
    for (const auto& p : x) ++first[cell_of(p) + 1];
    for (std::size_t c = 0; c < cells; ++c) first[c + 1] += first[c];
    for (std::size_t i = x.size(); i-- > 0;) of[--first[cell_of(x[i]) + 1]] = i;
    // Now first[c + 1] is where cell c begins: it ends where the next one does.
    std::vector<std::size_t> ahead;  // the half of the neighbours that comes later
    std::size_t all = 1;
    for (std::size_t k = 0; k < d; ++k) all *= 3;
    for (std::size_t code = all / 2 + 1; code < all; ++code) {
        std::ptrdiff_t off = 0;
        std::size_t rest = code;
        for (std::size_t k = 0; k < d; ++k, rest /= 3)
            off += static_cast<std::ptrdiff_t>(stride[k]) * (static_cast<std::ptrdiff_t>(rest % 3) - 1);
        ahead.push_back(static_cast<std::size_t>(off));
    }
    const auto begin = [&](std::size_t c) { return first[c + 1]; };
    const auto end = [&](std::size_t c) { return c + 2 <= cells ? first[c + 2] : x.size(); };
    for (std::size_t c = 0; c < cells; ++c)
        for (std::size_t a = begin(c); a < end(c); ++a) {
            for (std::size_t b = a + 1; b < end(c); ++b) f(of[a], of[b]);
            for (const std::size_t off : ahead)
                for (std::size_t b = begin(c + off); b < end(c + off); ++b) f(of[a], of[b]);
        }
}

}  // namespace bench
