// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/places.h>

namespace annulus::inline v1 {

/// Sign of the empty sphere of x = {a, b, p, q}, or {a, b, c, p, q}, for cospherical points, by CGAL's lexicographic
/// symbolic perturbation: never 0. Preconditions: evaluate_empty_sphere(x).sign == 0, and both cells are positive.
/// Depends on the order of positions, not on addresses.
///
/// CGAL's removal needs the triangulation that this perturbation selects (theory 6.7), so flips also decide
/// cospherical cases with it. Devillers and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D
/// triangulations, 2011. In 3D the rule is that of CGAL::Delaunay_triangulation_3::side_of_oriented_sphere.
[[nodiscard]] int perturbed_sign(const Tuple<2, 4>& x);
[[nodiscard]] int perturbed_sign(const Tuple<3, 5>& x);

}  // namespace annulus::inline v1
