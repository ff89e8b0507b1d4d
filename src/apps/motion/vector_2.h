// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cmath>

namespace annulus::inline v1 {

// 2D vectors in doubles, one rounding per operation.

inline Coordinates<2> plus(const Coordinates<2>& a, const Coordinates<2>& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Coordinates<2> minus(const Coordinates<2>& a, const Coordinates<2>& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline double dot(const Coordinates<2>& a, const Coordinates<2>& b) { return a[0] * b[0] + a[1] * b[1]; }
inline double cross(const Coordinates<2>& a, const Coordinates<2>& b) { return a[0] * b[1] - a[1] * b[0]; }
/// Without overflow.
inline double norm(const Coordinates<2>& a) { return std::hypot(a[0], a[1]); }

}  // namespace annulus::inline v1
