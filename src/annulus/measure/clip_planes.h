// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/voronoi.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A half-space, normal and offset multiplied by a power of two, so that the largest coordinate of the normal is in
/// [1, 2): exact, except for coordinates below 2^-1074. A long double has the range that the offset may need.
template <int d>
struct Clip_plane {
    Coordinates<d> normal{};
    long double offset = 0;

    /// offset - normal . x, which is positive inside: most digits may cancel, and a long double has some more.
    [[nodiscard]] long double inside(const Coordinates<d>& x) const {
        long double left = offset;
        for (std::size_t k = 0; k < d; ++k) left -= static_cast<long double>(normal[k]) * x[k];
        return left;
    }
    /// |offset| + |normal| . |x|: `inside` is off by less than 2^-61 times this.
    [[nodiscard]] long double terms(const Coordinates<d>& x) const {
        long double sum = std::fabs(offset);
        for (std::size_t k = 0; k < d; ++k) sum += std::fabs(static_cast<long double>(normal[k]) * x[k]);
        return sum;
    }
};

/// The planes of half-spaces. Throws not_finite; bad_input where one has no normal.
template <int d>
[[nodiscard]] std::vector<Clip_plane<d>> clip_planes(std::span<const Half_space<d>> half_spaces);

extern template std::vector<Clip_plane<2>> clip_planes<2>(std::span<const Half_space<2>>);
extern template std::vector<Clip_plane<3>> clip_planes<3>(std::span<const Half_space<3>>);

}  // namespace annulus::inline v1
