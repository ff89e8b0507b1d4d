// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/periodic_boxes.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace annulus::testing {

/// Every point is moved by nearly its tolerance in some direction: no cell may change.
template <int d>
void expect_safe_tolerances(const Periodic_mesh<d>& mesh, Periodic_cases& cases) {
    const std::vector<double> tolerance = mesh.tolerances();
    REQUIRE(tolerance.size() == mesh.index_bound());
    // The places are exact, also given again in the box as it was given.
    Periodic_mesh<d> pushed(mesh.saved(), {.strategy = Periodic_strategy::signs});
    std::vector<Coordinates<d>> x(mesh.places().begin(), mesh.places().end());
    CHECK(pushed.move_all(x).statistics.flips == 0);
    const auto before = cells_of(pushed);
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (!mesh.is_vertex(static_cast<Index>(v))) {
            CHECK(std::isnan(tolerance[v]));
            continue;
        }
        CHECK(tolerance[v] >= 0);
        Coordinates<d> way;
        double squares = 0;
        for (double& c : way) {
            c = cases.uniform(-1, 1);
            squares += c * c;
        }
        for (std::size_t i = 0; i < d; ++i) x[v][i] += 0.9999 * tolerance[v] * way[i] / std::sqrt(squares);
    }
    const Move_result result = pushed.move_all(x);
    CHECK(result.statistics.flips == 0);
    CHECK(result.moves.rebuilt == 0);
    CHECK(cells_of(pushed) == before);
}

}  // namespace annulus::testing
