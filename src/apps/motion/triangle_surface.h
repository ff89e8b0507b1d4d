// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <vector>

namespace annulus::inline v1 {

/// Triangles in 3D, counter-clockwise seen from outside where they bound something.
struct Triangle_surface {
    std::vector<Coordinates<3>> points;
    std::vector<std::array<Index, 3>> triangles;
};

/// Volume enclosed by a closed surface, in the cube of the unit of its points; negative when it is turned inside out.
/// Computed relative to the first point, so that a surface far from the origin loses no accuracy.
[[nodiscard]] inline double enclosed_volume(const Triangle_surface& surface) {
    double sum = 0;
    for (const auto& t : surface.triangles) {
        Coordinates<3> e[3];
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                e[i][k] = surface.points[static_cast<std::size_t>(t[i])][k] - surface.points[0][k];
        sum += e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
               e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    }
    return sum / 6;
}

}  // namespace annulus::inline v1
