// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cells_3.h>

#include <array>
#include <cmath>

namespace annulus::inline v1 {

/// The cosines of the six dihedral angles of a tetrahedron, of either orientation; NaN where a facet has no area. Plain
/// doubles: near 1 or -1 an angle is known to about 1e-8 only.
[[nodiscard]] inline std::array<double, 6> dihedral_cosines(const Coordinates<3>& a, const Coordinates<3>& b,
                                                            const Coordinates<3>& c, const Coordinates<3>& d) {
    const std::array<const Coordinates<3>*, 4> p{&a, &b, &c, &d};
    std::array<Coordinates<3>, 4> n;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& o = *p[facet_corners[i][0]];
        Coordinates<3> u, v;
        for (std::size_t k = 0; k < 3; ++k)
            u[k] = (*p[facet_corners[i][1]])[k] - o[k], v[k] = (*p[facet_corners[i][2]])[k] - o[k];
        n[i] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
        const double length = std::sqrt(n[i][0] * n[i][0] + n[i][1] * n[i][1] + n[i][2] * n[i][2]);
        for (double& x : n[i]) x /= length;
    }
    std::array<double, 6> cosines{};
    std::size_t e = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)  // facets with outer normals: the inner angle is the supplement
            cosines[e++] = -(n[i][0] * n[j][0] + n[i][1] * n[j][1] + n[i][2] * n[j][2]);
    return cosines;
}

}  // namespace annulus::inline v1
