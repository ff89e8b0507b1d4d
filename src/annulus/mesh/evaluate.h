// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

// One certificate at given positions, by all stages: for what is read off a triangulation, not for what keeps
// it right. Rounding mode to nearest; it is put back. Some hundred nanoseconds each.
namespace annulus {

/// The certificate of a facet, x[k] the position of its k-th point; where the determinant is 0 the perturbation
/// decides, or how the hull goes on (degenerate.h). Positive and without limit for a border, which has none of its
/// own.
[[nodiscard]] Certificate_value evaluate_facet(Facet_kind kind, const std::array<Coordinates<2>, 4>& x);
[[nodiscard]] Certificate_value evaluate_facet(Facet_kind kind, const std::array<Coordinates<3>, 5>& x);

/// The orientation of a finite cell.
[[nodiscard]] Certificate_value evaluate_cell(const std::array<Coordinates<2>, 3>& x);
[[nodiscard]] Certificate_value evaluate_cell(const std::array<Coordinates<3>, 4>& x);

/// The width of the annulus of a bi-cell, certified: the standard one in 2D, the least of four in 3D.
[[nodiscard]] double annulus_width_lower(const std::array<Coordinates<2>, 4>& x);
[[nodiscard]] double annulus_width_lower(const std::array<Coordinates<3>, 5>& x);

/// Theta of a bi-cell (theta.h), in radians.
[[nodiscard]] double bicell_theta(const std::array<Coordinates<2>, 4>& x);
[[nodiscard]] double bicell_theta(const std::array<Coordinates<3>, 5>& x);

}  // namespace annulus
