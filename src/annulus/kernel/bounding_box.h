// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

namespace annulus::inline v1 {

/// The smallest axis-parallel box around points of x.
template <int d>
struct Bounding_box {
    Coordinates<d> low, high;

    Bounding_box(std::span<const Coordinates<d>> x, std::span<const Index> vertices) {
        low.fill(std::numeric_limits<double>::infinity());
        high.fill(-std::numeric_limits<double>::infinity());
        for (const Index v : vertices) {
            const Coordinates<d>& p = x[static_cast<std::size_t>(v)];
            for (std::size_t c = 0; c < d; ++c) {
                low[c] = std::min(low[c], p[c]);
                high[c] = std::max(high[c], p[c]);
            }
        }
    }
    /// The box of the points multiplied by a power of two, which rounds none of them.
    [[nodiscard]] Bounding_box scaled(double factor) const {
        Bounding_box box = *this;
        for (std::size_t c = 0; c < d; ++c) {
            box.low[c] *= factor;
            box.high[c] *= factor;
        }
        return box;
    }
    /// Its longest side; 0 when all points are at one position, or there are none.
    [[nodiscard]] double extent() const {
        double longest = 0;
        for (std::size_t c = 0; c < d; ++c) longest = std::max(longest, high[c] - low[c]);
        return longest;
    }
};

}  // namespace annulus::inline v1
