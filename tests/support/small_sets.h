// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A few points at any distance from a degenerate configuration, in 2D and in 3D.

#include <support/generators.h>

#include <cmath>

namespace annulus::testing {

enum class Small_set { uniform, near_sphere, near_grid, near_flat, spindle };
inline constexpr std::array all_small_sets{Small_set::uniform, Small_set::near_sphere, Small_set::near_grid,
                                           Small_set::near_flat, Small_set::spindle};

/// n points in [-1, 3]^d, each off the configuration that names the set by up to `off` in every coordinate.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> small_set(Small_set set, std::size_t n, double off, Random& random) {
    const auto noise = [&] { return off * between(random, -1, 1); };
    std::vector<Coordinates<d>> x(n);
    for (std::size_t i = 0; i < n; ++i) {
        auto& p = x[i];
        for (double& c : p) c = between(random, -1, 1);
        switch (set) {
            case Small_set::uniform: break;
            case Small_set::near_sphere: {
                double square = 0;
                for (const double c : p) square += c * c;
                for (double& c : p) c *= (1 + noise()) / std::sqrt(square);
                break;
            }
            case Small_set::near_grid:
                for (double& c : p) c = integer(random, 0, 2) + noise();
                break;
            case Small_set::near_flat: p[d - 1] = noise(); break;
            case Small_set::spindle:  // two tips a little inside the sphere of a ring
                if (i < 2) {
                    p = {};
                    p[d - 1] = (i == 0 ? 1 : -1) * (1 - off);
                } else {
                    const double turn = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n - 2);
                    p[d - 1] = noise();
                    p[0] = std::cos(turn) * (1 + noise());
                    if constexpr (d == 3) p[1] = std::sin(turn) * (1 + noise());
                }
        }
    }
    return x;
}

}  // namespace annulus::testing
