// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Small sets for tests of Moving_mesh.

#include <annulus/moving_mesh.h>
#include <support/generators.h>

#include <algorithm>
#include <vector>

namespace annulus::testing {

template <int d>
using Points_d = std::vector<Coordinates<d>>;

/// Uniform in the unit cube.
template <int d>
Points_d<d> uniform(std::size_t n, Random& random) {
    Points_d<d> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0, 1);
    return x;
}

/// A sheared grid: partly cospherical, without duplicate points.
template <int d>
Points_d<d> grid() {
    Points_d<d> x;
    for (int i = 0; i < (d == 2 ? 25 : 27); ++i) {
        Coordinates<d> p{};
        const int side = d == 2 ? 5 : 3;
        for (int k = 0, rest = i; k < d; ++k, rest /= side) p[static_cast<std::size_t>(k)] = rest % side;
        p[0] += 0.125 * p[1];
        x.push_back(p);
    }
    return x;
}

template <int d>
auto sorted_cells(const Moving_mesh<d>& mesh) {
    auto cells = mesh.cells().vertices;
    for (auto& c : cells) std::sort(c.begin(), c.end());
    std::sort(cells.begin(), cells.end());
    return cells;
}

template <int d>
Points_d<d> sheared(Points_d<d> x, double by) {
    for (auto& p : x) p[1] += by * p[0];
    return x;
}

}  // namespace annulus::testing
