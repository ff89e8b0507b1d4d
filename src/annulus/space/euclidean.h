// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/site.h>

#include <array>
#include <functional>
#include <type_traits>

namespace annulus::inline v1 {

/// R^d: what the library needs of the space that the points are in.
template <int d>
struct Euclidean {
    static_assert(d == 2 || d == 3);
    using Site = Site_of<No_label>;
    static_assert(sizeof(Site) == sizeof(Index));

    /// p - q for two places: certificates, kernel, engine and statistics take differences from here. A place is any
    /// type whose [c] gives a coordinate, of any type that `minus` accepts: doubles, lanes of them, integers. Three
    /// kinds of differences are computed elsewhere: how far one vertex moved; those of the audit, which shares no code
    /// with what it checks; and those of cached_spheres.cpp and four_cells.h, in lanes of AVX2.
    template <class P, class Minus = std::minus<>>
    [[nodiscard]] static constexpr auto difference(const P& p, const P& q, Minus minus = {}) {
        using T = std::decay_t<decltype(minus(p[0], q[0]))>;
        if constexpr (d == 2) return std::array<T, 2>{minus(p[0], q[0]), minus(p[1], q[1])};
        else return std::array<T, 3>{minus(p[0], q[0]), minus(p[1], q[1]), minus(p[2], q[2])};
    }
};
template <int d>
using Site = typename Euclidean<d>::Site;

}  // namespace annulus::inline v1
