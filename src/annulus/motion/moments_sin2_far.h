// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/cell_2.h>
#include <annulus/motion/moments_2.h>

#include <span>

namespace annulus {

/// How large a region is, seen from its origin.
struct Size_2 {
    double radius;  ///< no less than the greatest distance of the region from its origin
    double edge2;   ///< square of the longest straight edge or chord
    double area;    ///< of the polygon of its corners
    bool arcs;      ///< whether an edge is an arc
};

/// `sin2_moments` of the kind "far": radius <= 1.5 and 4 radius < r = |origin|. Errors of `moments`; O(corners), no
/// allocation, the same bits on every machine for r < 1e5.
[[nodiscard]] Moments_2 far_sin2_moments(const Coordinates<2>& origin, double r, std::span<const Corner_2> corners,
                                         const Size_2& size);

}  // namespace annulus
