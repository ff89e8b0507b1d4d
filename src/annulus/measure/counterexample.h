// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/certificate_value.h>

namespace annulus::inline v1 {

/// Five points in 3D at which the paper's tolerance is too large (docs/theory.md 3), moved by less than it: a and b on
/// the axis, inside the unit sphere by delta; p, q and r around them at 120 degrees.
struct Counterexample {
    double delta;
    double move;       ///< 0.7 delta, as requested: a and b outward, p, q and r inward
    double displaced;  ///< an upper bound of the largest displacement, rounding of the moved points included
    double paper;      ///< least half width of the standard annuli, plain double
    double theta;      ///< least theta of the facets
    Certificate_value certified;
    double exact;                               ///< the largest double that is not above the tolerance
    bool three_before, three_after, two_after;  ///< whether three cells around a b, or two at p q r, are Delaunay
};

/// Tests the five points before and after the move, exactly. Throws Error(usage) unless 2^-40 <= delta <= 0.1.
[[nodiscard]] Counterexample counterexample(double delta);

}  // namespace annulus::inline v1
