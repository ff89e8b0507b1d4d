// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

// One certificate at given positions, by all stages. For measurements of a triangulation, not for its updates. Needs
// rounding to nearest, and restores it. Some hundred nanoseconds each.
namespace annulus::inline v1 {

/// The certificate of a facet; x[k] is the position of its k-th point. Where the determinant is 0 the perturbation
/// decides, or whether the hull is convex there (degenerate.h). Positive with infinite tolerance for a border, which
/// has no certificate of its own.
[[nodiscard]] Certificate_value evaluate_facet(Facet_kind kind, const std::array<Coordinates<2>, 4>& x);
[[nodiscard]] Certificate_value evaluate_facet(Facet_kind kind, const std::array<Coordinates<3>, 5>& x);

/// The orientation of a finite cell.
[[nodiscard]] Certificate_value evaluate_cell(const std::array<Coordinates<2>, 3>& x);
[[nodiscard]] Certificate_value evaluate_cell(const std::array<Coordinates<3>, 4>& x);

/// A certified lower bound of the width of the annulus of a bi-cell: the standard one in 2D, the least of four in 3D.
[[nodiscard]] double annulus_width_lower(const std::array<Coordinates<2>, 4>& x);
[[nodiscard]] double annulus_width_lower(const std::array<Coordinates<3>, 5>& x);

/// Theta of a bi-cell (theta.h), in radians.
[[nodiscard]] double bicell_theta(const std::array<Coordinates<2>, 4>& x);
[[nodiscard]] double bicell_theta(const std::array<Coordinates<3>, 5>& x);

}  // namespace annulus::inline v1
