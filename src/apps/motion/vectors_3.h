// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cmath>

namespace annulus::inline v1 {

// 3D vectors in plain doubles, for motions. In the caller's unit of length.

[[nodiscard]] inline Coordinates<3> minus(const Coordinates<3>& p, const Coordinates<3>& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
[[nodiscard]] inline Coordinates<3> cross(const Coordinates<3>& p, const Coordinates<3>& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
[[nodiscard]] inline double dot(const Coordinates<3>& p, const Coordinates<3>& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
[[nodiscard]] inline double distance(const Coordinates<3>& p, const Coordinates<3>& q) {
    return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}
/// p + t (q - p).
[[nodiscard]] inline Coordinates<3> between(const Coordinates<3>& p, const Coordinates<3>& q, double t) {
    return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
}

}  // namespace annulus::inline v1
