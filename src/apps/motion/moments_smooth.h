// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cell_2.h>
#include <apps/motion/density_2.h>
#include <apps/motion/moments_2.h>

#include <span>

namespace annulus::inline v1 {

/// The size of a region, seen from its origin.
struct Size_2 {
    double radius;  ///< no less than the greatest distance of the region from its origin
    double edge;    ///< the longest straight edge or chord
    double area;    ///< of the polygon of its corners
    bool arcs;      ///< whether an edge is an arc
};
[[nodiscard]] Size_2 size_of(const Coordinates<2>& origin, std::span<const Corner_2> corners);

/// Moments under a density f of which the derivatives are known to be small: along a line, of order k, at most A q^k,
/// A the amplitude and q the rate. See `moments`.
///
/// The region is the union of the cones from its origin c to the pieces of its boundary. Over the cone to an edge a,
/// b it integrates w t f(c + t e) (1, t e) over t and s from 0 to 1, e = a + s (b - a), w = cross(a, b): n
/// Gauss-Legendre nodes along the edge, n Gauss-Jacobi nodes for the weight t along the ray. Remainders of Gauss
/// rules (Abramowitz and Stegun 25.4) with
///
///     R_n = (n! (n + 1)!)^2 / ((n + 1) (2n + 1)!^2 (2n)!)      along rays, relative to the integral of t
///     S_n = n!^4 / ((2n + 1) (2n)!^3)                          along edges
///
/// and x = q h, y = q times the longest edge, h the greatest distance from c: the integrands' derivatives of order 2n
/// are at most A (x^2n + 2n x^(2n - 1)) h along a ray and A (y^2n + 2n y^2n / x) h along an edge for the first
/// moments, and less for the mass. All weights are positive and sum up to the area, so the error is at most
///
///     A area (R_n (x^2n + 2n x^(2n - 1)) + S_n (y^2n + 2n y^2n / x))
///
/// for the mass, and that times h for the first moments. n, from 2 to 6, is raised until this is 1e-9 of the mass
/// that was found. Where x or y is above 2, and where 6 do not suffice, edges and rays are cut in pieces with q times
/// their length at most 2 and 6 Gauss-Legendre nodes each, for t f and t^2 f along rays: less than 1e-10 A area is
/// left.
///
/// Arcs of radius r are cut in pieces of which y = q times the length is at most 4 and the angle s at most pi / 4,
/// with m Gauss-Legendre nodes: n + 1, or 12 where edges and rays are cut. Where f is entire of exponential type q,
/// as sin2 is, it is at most A exp(q r sinh v) at angles of imaginary part v, and what is left is about that times
/// p^-2m for p - 1 / p = 4 v / s (Trefethen, Approximation Theory and Practice, 19.3); v = min(2m / (q r), 1) makes
/// it (e y / 8m)^2m or less, far below what edges leave.
[[nodiscard]] Moments_2 smooth_moments(const Smooth_density& density, const Coordinates<2>& origin,
                                       std::span<const Corner_2> corners);

/// The same for the density sin^2 r, r the distance from (0, 0), at several positions at a time: half the time.
[[nodiscard]] Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners);

}  // namespace annulus::inline v1
