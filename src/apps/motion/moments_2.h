// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cell_2.h>
#include <apps/motion/density_2.h>

#include <span>

namespace annulus::inline v1 {

/// Mass and first moment of a planar region under a density.
struct Moments_2 {
    double mass = 0;         ///< integral of density
    Coordinates<2> first{};  ///< integral of density times (position - origin)
};

/// The moments of the region whose boundary is `corners` (offsets from `origin`, counter-clockwise, see Corner_2), the
/// first moments about `origin`; the region's centroid is origin + first / mass. Fewer than 2 corners: zero.
///
/// Works on any region with such a boundary. The errors below hold for a convex region that is not a sliver and has
/// `origin` in it or on its border, as a Voronoi cell has its site. h is its diameter. The errors are relative to the
/// mass, and for the first moment to mass times h.
///
/// * `one`, `x2+y2`, `x2`: exact up to rounding, about 1e-15, wherever the cell is. The region is the union of the
///   cones from the origin to its edges; along a ray the integral of a quadratic is in closed form, and along an edge
///   what remains is a cubic, which Simpson's rule integrates exactly. On an arc 12 nodes per eighth of a turn leave
///   less than 1e-20 of the radius' power.
/// * `sin2`: 1e-9, plus the effect of one rounding of |origin| on the argument of the sine, which moves the centroid
///   by a few roundings of its coordinates. Proof in moments_smooth.h. O(corners), and where h > 1 O(h * perimeter).
/// * Smooth_density: the same where the mean density in the region is more than a hundredth of its amplitude; where
///   it is less, 1e-11 of amplitude times area; with rate * h in place of 2 h.
/// * Image_density: 1e-12 for cells no smaller than a pixel, and that times the pixel over h for smaller ones;
///   straight edges only. O(rows and columns of pixels that the edges cross). See moments_image.h.
///
/// * Placed_image: the same for the region as it is in the image.
///
/// No allocation, but for a Placed_image and more than 32 corners. Thread-safe.
[[nodiscard]] Moments_2 moments(Density density, const Coordinates<2>& origin, std::span<const Corner_2> corners);
[[nodiscard]] Moments_2 moments(const Density_2& density, const Coordinates<2>& origin,
                                std::span<const Corner_2> corners);

}  // namespace annulus::inline v1
