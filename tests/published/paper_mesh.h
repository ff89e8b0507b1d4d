// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A mesh that moves by any variant of the paper's algorithms, and points to start with.

#include <annulus/engine/engine.h>
#include <annulus/published/strategies.h>

#include <support/generators.h>

#include <algorithm>
#include <set>
#include <span>
#include <vector>

namespace annulus::testing {

template <int d>
std::vector<Coordinates<d>> random_places(std::size_t n, Random& random) {
    std::vector<Coordinates<d>> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0.0, 1.0);
    return x;
}

/// Moves each point by at most half the pace in each coordinate.
template <int d>
void stir(std::vector<Coordinates<d>>& x, double pace, Random& random) {
    for (auto& p : x)
        for (double& c : p) c += pace * between(random, -0.5, 0.5);
}

template <int d>
struct Paper_mesh {
    Delaunay_mesh<d> mesh;
    Engine<d> engine;

    Paper_mesh(std::span<const Coordinates<d>> x, const Paper_choice& choice,
               Tolerance_kind kind = Tolerance_kind::paper)
        : engine(mesh, {}, make_paper<d>(mesh, choice, kind)) {
        engine.build(x);
    }
    /// Whether the cells are Delaunay at the moving positions.
    [[nodiscard]] bool delaunay() const { return audit(engine.audit_input()).delaunay(); }
    /// Whether the same cells are Delaunay at the fixed positions.
    [[nodiscard]] bool delaunay_at_fixed() const {
        Audit_input<d> input = engine.audit_input();
        for (std::size_t i = 0; i < input.points.size(); ++i) input.points[i] = engine.fixed_position(input.names[i]);
        return audit(input).delaunay();
    }
    [[nodiscard]] bool is_at_fixed_position(Index v) const {
        return engine.fixed_position(v) == engine.positions()[static_cast<std::size_t>(v)];
    }
};

/// The finite cells, each sorted.
template <int d>
std::set<std::vector<Index>> cell_set(const Engine<d>& engine) {
    std::set<std::vector<Index>> cells;
    for (const auto& cell : engine.audit_input().cells) {
        std::vector<Index> sorted(cell.begin(), cell.end());
        std::sort(sorted.begin(), sorted.end());
        cells.insert(sorted);
    }
    return cells;
}

}  // namespace annulus::testing
