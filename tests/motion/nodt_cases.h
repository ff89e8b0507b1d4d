// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes that tests of natural ODT begin with.
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/cells_3.h>

#include <array>
#include <cmath>
#include <vector>

namespace annulus_test {

using namespace annulus;

using Points = std::vector<Coordinates<3>>;

inline double distance(const Coordinates<3>& a, const Coordinates<3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

inline Mesh_cells<3> cells_of(const Points& points) {
    Options options;
    options.strategy = Strategy::rebuild;
    return linked(Moving_delaunay_3(points, options).audit_input().cells, points.size());
}

/// The body-centred cubic lattice with edge 1, scaled, inside a cube. No five of it that share a sphere are adjacent.
inline Points body_centred(int n, double scale) {
    Points points;
    for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
            for (int k = -n; k <= n; ++k)
                for (const double half : {0.0, 0.5})
                    points.push_back({scale * (i + half), scale * (j + half), scale * (k + half)});
    return points;
}

// Vectors in long double, for the definition of targets and energies.
using Real = long double;
using Vector = std::array<Real, 3>;

inline Vector minus(const Coordinates<3>& a, const Coordinates<3>& b) {
    return {Real{a[0]} - b[0], Real{a[1]} - b[1], Real{a[2]} - b[2]};
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace annulus_test
