// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Where points of some motions begin, and a flow.

#include <annulus/types.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace annulus::testing {

/// Points that are exactly on one circle or sphere.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> integer_points_of_one_norm() {
    std::vector<Coordinates<d>> points;
    if constexpr (d == 2) {
        constexpr int r = 32045;  // 5 * 13 * 17 * 29: 324 points
        for (int x = -r; x <= r; ++x) {
            const double square = static_cast<double>(r) * r - static_cast<double>(x) * x;
            const double y = std::sqrt(square);  // exact where it is an integer
            if (y != std::floor(y)) continue;
            points.push_back({x * 0x1p-16, y * 0x1p-16});
            if (y != 0) points.push_back({x * 0x1p-16, -y * 0x1p-16});
        }
    } else {
        constexpr int r = 45;
        for (int x = -r; x <= r; ++x)
            for (int y = -r; y <= r; ++y)
                for (int z = -r; z <= r; ++z)
                    if (x * x + y * y + z * z == r * r) points.push_back({x * 0x1p-6, y * 0x1p-6, z * 0x1p-6});
    }
    return points;
}

/// The velocity at p: Taylor and Green's vortices in 2D, one of the flows of Arnold, Beltrami and Childress in 3D.
template <int d>
[[nodiscard]] Coordinates<d> steady_flow(const Coordinates<d>& p, double frequency) {
    constexpr double pi = std::numbers::pi;
    if constexpr (d == 2) {
        return {std::sin(pi * frequency * p[0]) * std::cos(pi * frequency * p[1]),
                -std::cos(pi * frequency * p[0]) * std::sin(pi * frequency * p[1])};
    } else {
        return {std::sin(pi * frequency * p[2]) + std::cos(pi * frequency * p[1]),
                std::sin(pi * frequency * p[0]) + std::cos(pi * frequency * p[2]),
                std::sin(pi * frequency * p[1]) + std::cos(pi * frequency * p[0])};
    }
}

}  // namespace annulus::testing
