// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cell_2.h>
#include <apps/motion/density_2.h>

#include <vector>

namespace annulus::inline v1 {

/// The corners of a cell as positions; an arc becomes a polyline of pieces of a fiftieth of a radian at most.
[[nodiscard]] std::vector<Coordinates<2>> outline_of(const Cell_2& cell);

/// The integral over a cell of the density times the squared distance to `site`, a point in it or near it: the share of
/// the cell in the energy that Lloyd's iterations decrease. In the units of the density and of length^4.
///
/// Seven nodes (Radon's rule, degree 5) in each triangle of the site and an edge of the outline. So it is exact up to
/// rounding for `one`, `x2` and `x2+y2` where the cell has straight edges, and off by less than 2e-4 of it for arcs;
/// for other densities it is an approximation, the better the less the density varies within a cell. O(corners), no
/// more than the outline is allocated.
[[nodiscard]] double cell_energy(const Density_2& density, const Cell_2& cell, const Coordinates<2>& site);

}  // namespace annulus::inline v1
