// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/cell_2.h>
#include <annulus/motion/moments_2.h>

#include <span>

namespace annulus {

/// Moments under the density sin^2 r, r the distance from (0, 0): see `moments`. A short cut through `smooth_moments`, which it
/// leaves to do what it does not suit: cells that are large, near (0, 0), or at the border of a disc.
///
/// Green's theorem in polar form makes integrals along the boundary of them, of a potential that is measured from the circle through the
/// origin c, so that it is small where the cell is small: the integral of the density as a power series in (r^2 - |c|^2) / (2 |c|),
/// coefficients made once a cell. Four Gauss nodes an edge and degree 7, or eight and 13, whichever leaves out less than 1e-9 of the mass.
[[nodiscard]] Moments_2 sin2_moments(const Coordinates<2>& origin, std::span<const Corner_2> corners);

}  // namespace annulus
