// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>

#include <array>
#include <cstddef>
#include <vector>

// Crystals, as bases of fractions of an edge, and boxes of theirs.
namespace annulus::testing {

/// k cells in each direction, of edge a.
template <int d>
std::vector<Coordinates<d>> crystal(const std::vector<Coordinates<d>>& basis, int k, double a) {
    std::vector<Coordinates<d>> x;
    for (int z = 0; z < (d == 3 ? k : 1); ++z)
        for (int y = 0; y < k; ++y)
            for (int w = 0; w < k; ++w)
                for (const auto& b : basis) {
                    Coordinates<d> p{};
                    const std::array<int, 3> at{w, y, z};
                    for (std::size_t i = 0; i < d; ++i) p[i] = a * (at[i] + b[i]);
                    x.push_back(p);
                }
    return x;
}

inline const std::vector<Coordinates<3>> sc{{0, 0, 0}};
inline const std::vector<Coordinates<3>> bcc{{0, 0, 0}, {.5, .5, .5}};
inline const std::vector<Coordinates<3>> fcc{{0, 0, 0}, {.5, .5, 0}, {.5, 0, .5}, {0, .5, .5}};
inline const std::vector<Coordinates<3>> diamond{{0, 0, 0},       {.5, .5, 0},     {.5, 0, .5},     {0, .5, .5},
                                                 {.25, .25, .25}, {.75, .75, .25}, {.75, .25, .75}, {.25, .75, .75}};

template <int d>
Box<d> cube(double length) {
    Coordinates<d> lengths;
    lengths.fill(length);
    return Box<d>::orthorhombic(lengths);
}

}  // namespace annulus::testing
