// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/cell_2.h>
#include <annulus/motion/moments_2.h>

#include <span>

namespace annulus {

/// Moments under the density sin^2 r, r the distance from (0, 0): see `moments`. Green's theorem in polar form turns
/// them into integrals along the boundary, with a potential for each of three kinds of cell; h is the greatest
/// distance of the cell from its origin c.
///
/// * far (h <= 1.5, |c| > 4 h): the potential is measured from the circle through c, so that it is small where the cell
///   is small: the integral of the density as a power series in (r^2 - |c|^2) / (2 |c|), coefficients made once a cell.
///   Degree and nodes are one of three pairs, for an error below 1e-13 of the mass: see moments_sin2_far.cpp.
/// * near (h <= 1, |c| <= 4 h): measured from (0, 0): G(r) / r^2 and H(r) / r^3, which are entire functions of r^2;
///   series for r < 1, closed form from there on.
/// * large (the rest, h > 1): sin^2 = 1/2 - cos(2 r) / 2; the first half is a polygon's area, the second oscillates,
///   and its potentials grow only like r.
///
/// In each the integrand along an edge is smooth (of exponential type 2, Bernstein: its k-th derivative by arc length
/// is of order 2^k), and the number of Gauss nodes follows from the length of the edges by a bound for the remainder;
/// no step is adaptive.
[[nodiscard]] Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners);

/// (1/r^2) times the integral of sin^2(t) t over [0, r], and (1/r^3) times that of sin^2(t) t^2. Relative error 1e-15
/// for r < 1 and absolute error 1e-15 above.
struct Radial_means {
    double g, h;
};
[[nodiscard]] Radial_means sin2_means(double r);

/// The same with cos(2 t) in place of sin^2(t); absolute error 1e-15, and 1e-15 / r for large r.
[[nodiscard]] Radial_means cos2_means(double r);

}  // namespace annulus
