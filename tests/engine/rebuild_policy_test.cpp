// SPDX-License-Identifier: GPL-3.0-or-later
// When vertices are no longer moved one by one, and when repair gives up (engine/rebuild_policy.h), by the steps and
// counted costs that calls of Moving_mesh report. No clock is read.
#include <annulus/engine/cost_model.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Positions = std::vector<Coordinates<d>>;

template <int d>
Positions<d> uniform(std::size_t n) {
    Random random(11);
    Positions<d> x(n);
    for (auto& p : x)
        for (double& c : p) c = unit(random);
    return x;
}

/// A lattice of 24 points a side, each moved by 0.002 of a lattice constant at most.
Positions<3> nearly_a_lattice(std::size_t n) {
    Positions<3> x = uniform<3>(n);
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t c = 0, rest = k; c < 3; ++c, rest /= 24)
            x[k][c] = static_cast<double>(rest % 24) / 32 + 0x1p-14 * x[k][c];
    return x;
}

template <int d>
Moving_mesh<d> mesh_of(const Positions<d>& x) {
    return Moving_mesh<d>(std::span<const Coordinates<d>>(x));
}

/// So many spacings along the first axis, towards the middle.
template <int d>
Coordinates<d> shifted(Coordinates<d> p, std::size_t n, double spacings) {
    p[0] += (p[0] < 0.5 ? 1 : -1) * spacings * std::pow(static_cast<double>(n), -1.0 / d);
    return p;
}

/// The last `movers` vertices move: by so many spacings the last `far` of them, which are moved first, and by 0.01 the
/// others.
template <int d>
Move_result move_last(Moving_mesh<d>& mesh, std::size_t movers, std::size_t far, double spacings) {
    const std::size_t n = mesh.number_of_vertices();
    std::vector<Index> indices;
    Positions<d> to;
    for (std::size_t k = 0; k < movers; ++k) {
        indices.push_back(static_cast<Index>(n - 1 - k));
        to.push_back(shifted<d>(mesh.points()[n - 1 - k], n, k < far ? spacings : 0.01));
    }
    const Move_result result = mesh.move(std::span<const Index>(indices), std::span<const Coordinates<d>>(to));
    CHECK(result.moves.asked == movers);
    REQUIRE(mesh.audit().delaunay());
    return result;
}

std::uint64_t steps(const Move_statistics& s) { return s.tolerance_steps + s.sign_steps + s.rebuild_steps; }

}  // namespace

TEMPLATE_TEST_CASE_SIG("A 64th of the vertices moves one by one, one vertex more in a time step, dimension", "[engine]",
                       ((int d), d), 2, 3) {
    for (const std::size_t n : {639U, 640U, 641U, 703U, 704U}) {
        CAPTURE(n);
        const Moving_mesh<d> mesh = mesh_of<d>(uniform<d>(n));
        Moving_mesh<d> one = mesh, other = mesh;
        CHECK(steps(move_last<d>(one, n / 64, 0, 0).statistics) == 0);
        CHECK(steps(move_last<d>(other, n / 64 + 1, 0, 0).statistics) == 1);
    }
}

// The first one alone costs so much that all movers would cost more than a rebuild, if they were like it. In 3D that is
// so where points are nearly degenerate: of uniform points each is reinserted for less.
TEMPLATE_TEST_CASE_SIG("One mover that costs much is no evidence that all of them do, dimension", "[deep][engine]",
                       ((int d), d), 2, 3) {
    constexpr std::size_t n = 12800, movers = n / 64;
    Positions<d> points = uniform<d>(n);
    if constexpr (d == 3) points = nearly_a_lattice(n);
    const Moving_mesh<d> mesh = mesh_of<d>(points);
    const double rebuild = Cost_model<d>::rebuild * static_cast<double>(n);
    const auto cost_of_far = [&](std::size_t far) {
        Moving_mesh<d> copy = mesh;
        return move_last<d>(copy, far, far, 20).statistics.cost;
    };
    // As many far movers as are expensive, but less than an eighth of a rebuild.
    std::size_t few = 1;
    while (cost_of_far(few) * static_cast<double>(movers) <= rebuild * static_cast<double>(few)) REQUIRE(++few < 4);
    const double cost = cost_of_far(few);
    REQUIRE(cost < rebuild / 8.0);
    Moving_mesh<d> calm = mesh;
    const Move_result kept = move_last<d>(calm, movers, few, 20);
    CAPTURE(rebuild, cost, kept.statistics.cost);
    CHECK(steps(kept.statistics) == 0);
    CHECK(kept.moves.rebuilt == 0);
    CHECK(kept.statistics.cost < rebuild / 2.0);
    // When they all go far, an eighth of a rebuild is spent, and what one mover costs; then all is rebuilt, once.
    Moving_mesh<d> wild = mesh;
    const Move_result rebuilt = move_last<d>(wild, movers, movers, 20);
    CAPTURE(rebuilt.statistics.cost, rebuilt.moves.rebuilt);
    CHECK(rebuilt.moves.rebuilt == movers);
    CHECK(rebuilt.statistics.cost > rebuild * 1.125);
    CHECK(rebuilt.statistics.cost < rebuild * 1.125 + 4.0 * cost);
}

TEMPLATE_TEST_CASE_SIG("Moves of points on a line cost as many rebuilds as they are, dimension", "[engine]",
                       ((int d), d), 2, 3) {
    constexpr std::size_t n = 50;
    Positions<d> x(n);
    for (std::size_t k = 0; k < n; ++k) x[k][0] = static_cast<double>(k);
    Moving_mesh<d> mesh = mesh_of<d>(x);
    const double rebuild = Cost_model<d>::rebuild * static_cast<double>(n);
    x[0][0] = 0.5;
    CHECK(mesh.move_all(std::span<const Coordinates<d>>(x)).statistics.cost == rebuild);
    CHECK(mesh.move(0, Coordinates<d>{0.25}).statistics.cost == rebuild);
}

// Steps of all sizes, each of a mesh that has been repaired so far.
TEMPLATE_TEST_CASE_SIG("Repair gives up before it has cost as much as a rebuild, dimension", "[engine]", ((int d), d),
                       2, 3) {
    constexpr std::size_t n = 2000;
    const Positions<d> x = uniform<d>(n);
    const double rebuild = Cost_model<d>::rebuild * static_cast<double>(n);
    double most_repaired = 0.0, most_given_up = 0.0;
    for (double spacings = 0.02; spacings < 2.0; spacings *= 1.3) {
        CAPTURE(spacings);
        Moving_mesh<d> mesh = mesh_of<d>(x);
        Random random(12);
        Positions<d> y = x;
        for (auto& p : y)
            for (double& c : p) c += 1e-6 * between(random, -1, 1);
        (void)mesh.move_all(std::span<const Coordinates<d>>(y));
        for (auto& p : y)
            for (double& c : p) c += spacings * std::pow(static_cast<double>(n), -1.0 / d) * between(random, -1, 1);
        const Move_result result = mesh.move_all(std::span<const Coordinates<d>>(y));
        REQUIRE(mesh.audit().delaunay());
        const double cost = result.statistics.cost;
        CAPTURE(cost / rebuild, result.moves.rebuilt, result.statistics.flips, result.statistics.undone_flips);
        double& most = result.moves.rebuilt == n ? most_given_up : most_repaired;
        most = std::max(most, cost / rebuild);
    }
    CAPTURE(most_repaired, most_given_up);
    CHECK(most_repaired > 0.3);
    CHECK(most_repaired < 1.0);
    CHECK(most_given_up > 1.0);
    CHECK(most_given_up < 2.0);
}
