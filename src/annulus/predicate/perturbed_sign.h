// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/places.h>

namespace annulus {

/// Sign of the empty sphere of x = {a, b, p, q}, or {a, b, c, p, q}, with the lexicographic symbolic perturbation
/// that CGAL has, where the points are cospherical: never 0. Preconditions: evaluate_empty_sphere(x).sign == 0, and
/// both cells are positive. By order of places, whatever their addresses.
///
/// CGAL's removal relies on the triangulation being the one this perturbation picks (theory 6.7), so that flips decide
/// cospherical cases with it. Devillers and Teillaud, Perturbations for Delaunay and weighted Delaunay 3D
/// triangulations, 2011. In 3D the rule is that of CGAL::Delaunay_triangulation_3::side_of_oriented_sphere.
[[nodiscard]] int perturbed_sign(const Tuple<2, 4>& x);
[[nodiscard]] int perturbed_sign(const Tuple<3, 5>& x);

}  // namespace annulus
