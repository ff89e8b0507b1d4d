// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/perturbed_sign.h>
#include <annulus/predicate/sure_orientation.h>

#include <algorithm>
#include <array>

// What decides a certificate whose determinant is 0 (docs/theory.md 6.7). Overloaded by the tuple, hence by dimension.
namespace annulus::inline v1 {

/// Whether the sphere of a positive cell holds p, exactly. If it passes through p the perturbation decides.
template <int d>
[[nodiscard]] bool sphere_holds_exactly(const Tuple<d, d + 1>& cell, const Coordinates<d>& p) {
    Tuple<d, d + 2> x{};  // in the order of the predicates: p before the last corner
    std::copy_n(cell.begin(), d, x.begin());
    x[d] = &p;
    x[d + 1] = cell[d];
    const int sign = exact_empty_sphere_sign(x).sign;
    return (sign != 0 ? sign : perturbed_sign(x)) < 0;
}

/// A ridge of determinant 0 holds unless the hull folds back there. In 2D x is {u, w, v} with v the vertex of the
/// ridge: v has to lie between its neighbours.
[[nodiscard]] inline bool flat_ridge_holds(const Tuple<2, 3>& x) {
    return (precedes(x, 0, 2) && precedes(x, 2, 1)) || (precedes(x, 1, 2) && precedes(x, 2, 0));
}
/// In 3D x is {u, w, c, d} with u w the ridge: c and d have to lie on different sides of it, in the plane that all
/// share.
[[nodiscard]] inline bool flat_ridge_holds(const Tuple<3, 4>& x) {
    for (std::size_t i = 0; i < 3; ++i) {  // seen along an axis that is not parallel to the plane
        const auto y = seen_along<4>(i, x);
        const int c = sure_orientation<2>({&y[0], &y[1], &y[2]});
        if (c != 0) return sure_orientation<2>({&y[0], &y[1], &y[3]}) == -c;
    }
    return false;
}

}  // namespace annulus::inline v1
