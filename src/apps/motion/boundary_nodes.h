// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cell_2.h>
#include <apps/motion/gauss_legendre.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace annulus::inline v1 {

/// Calls node(u, d) for Gauss nodes u (offset from the cell's origin) on the straight edge from a to b; d is the
/// tangent times the weight, so that a line integral of a field F is the sum of cross(F(u), d). The edge is cut into
/// `pieces` equal pieces with `rule` on each.
template <class Node>
void edge_nodes(const Coordinates<2>& a, const Coordinates<2>& b, const Gauss_rule& rule, int pieces, Node&& node) {
    const Coordinates<2> d{b[0] - a[0], b[1] - a[1]};
    const double part = 1.0 / pieces;
    for (int piece = 0; piece < pieces; ++piece)
        for (std::size_t j = 0; j < static_cast<std::size_t>(rule.size); ++j) {
            const double t = (piece + rule.node[j]) * part, w = rule.weight[j] * part;
            node(Coordinates<2>{a[0] + t * d[0], a[1] + t * d[1]}, Coordinates<2>{w * d[0], w * d[1]});
        }
}

/// The same along the arc around (0, 0) from a to b, with `rule` on every `longest` radians, an eighth of a turn at
/// most.
///
/// For a trigonometric polynomial of degree k <= 6 the remainder of the 12-point rule on an angle s <= pi/4 is at most
/// s^25 (12!)^4 / (25 (24!)^3) k^24 (Abramowitz and Stegun 25.4.30), below 1e-21 times its maximum for s = pi/4.
template <class Node>
void arc_nodes(const Coordinates<2>& origin, const Coordinates<2>& a, const Coordinates<2>& b, Node&& node,
               const Gauss_rule& rule = gauss_rule(12), double longest = std::numbers::pi / 4) {
    const double span = arc_span(origin, a, b);
    const int pieces = 1 + static_cast<int>(span / std::min(longest, std::numbers::pi / 4));
    const double part = span / pieces;
    const Coordinates<2> p{origin[0] + a[0], origin[1] + a[1]};
    for (int piece = 0; piece < pieces; ++piece)
        for (std::size_t j = 0; j < static_cast<std::size_t>(rule.size); ++j) {
            const double angle = (piece + rule.node[j]) * part, w = rule.weight[j] * part;
            // Rotate p by the angle and subtract p, without cancellation: cos - 1 = -2 sin^2 of the half.
            const double s = std::sin(angle), s_half = std::sin(angle / 2), c_less_1 = -2 * s_half * s_half;
            const Coordinates<2> step{p[0] * c_less_1 - p[1] * s, p[1] * c_less_1 + p[0] * s};
            node(Coordinates<2>{a[0] + step[0], a[1] + step[1]},
                 Coordinates<2>{-w * (p[1] + step[1]), w * (p[0] + step[0])});
        }
}

}  // namespace annulus::inline v1
