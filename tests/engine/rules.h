// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the tables of rules share: rules_test.cpp, error_vertices_test.cpp.
#include <annulus/moving_mesh.h>

#include <support/generators.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus::testing::rules {

inline constexpr Strategy strategies[] = {Strategy::automatic,       Strategy::rebuild,  Strategy::relocate,
                                          Strategy::relocate_flips,  Strategy::in_place, Strategy::tolerances,
                                          Strategy::tolerances_each, Strategy::paper,    Strategy::paper_hybrid};

template <int d>
using Positions = std::vector<Coordinates<d>>;

template <int d>
std::span<const Coordinates<d>> span_of(const Positions<d>& x) {
    return x;
}

template <int d>
Positions<d> some_points(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    Positions<d> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0, 1);
    return x;
}

}  // namespace annulus::testing::rules
