// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cell_2.h>
#include <apps/motion/image_density.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/placed_image.h>

#include <span>

namespace annulus::inline v1 {

/// Moments of a polygon under the density of an image: see `moments`. With P(x, y) the integral of the density along
/// the row from a node near the origin to x, and Q that of density times (x - c_x), Green's theorem makes them the
/// integrals of P, Q and (y - c_y) P over y along the boundary. Between four nodes P is of degree 2 in x, Q of degree
/// 3, both of degree 1 in y; so along a piece of an edge all integrands are polynomials of degree 4 at most, and three
/// Gauss nodes are exact. No pixel inside the region is read: O(pixels that the edges cross).
///
/// Relative to the mass the rounding is about 1e-16 (1 + 1 / h) times the quotient of the sum of the |P dy| and the
/// mass; where that is above 1e10 the mass cannot be distinguished from 0, and all moments are 0. Precondition: no arcs
/// (they are taken for their chords).
[[nodiscard]] Moments_2 image_moments(const Image_density& density, const Coordinates<2>& origin,
                                      std::span<const Corner_2> corners);

/// Moments of a polygon under an image that is laid over a rectangle: those of the polygon as it is in the image.
[[nodiscard]] Moments_2 placed_moments(const Placed_image& density, const Coordinates<2>& origin,
                                       std::span<const Corner_2> corners);

}  // namespace annulus::inline v1
