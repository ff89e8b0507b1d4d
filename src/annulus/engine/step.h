// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/horizons.h>
#include <annulus/engine/expiry_list.h>
#include <annulus/engine/vertex_record.h>
#include <annulus/mesh/index.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Which certificates a step evaluates: those that expired; without tolerances all those of the vertex that moves, or all.
enum class Scope : std::uint8_t { expired, star, everything };

/// New expiries, or rooms, of the points of a facet whose certificate a second look proved: in the order of bicell_points().
template <int d>
struct Renewal {
    Corner_index facet;
    std::array<double, static_cast<std::size_t>(d + 2)> expiry{};
};

/// A cache line, or one and a half: around a vertex are 12 certificates in the plane, 80 in space.
template <int d>
using Vertex_expiries = Expiry_list<Horizons::listed(d)>;

/// A step on its way: where vertices go, and what each stage found and the next is handed: who left its tolerance, which certificates
/// expired (the suspects of Repair), what was seen and mended, what is to be written down. An exception drops it.
template <int d>
struct Step {
    /// What a vertex was before its odometer was read.
    struct Before {
        Vertex_record<d> record;
        Vertex_expiries<d> list;
    };

    std::span<const Coordinates<d>> x;  ///< goals, by vertex
    Index mover = none;                 ///< the vertex that moves alone
    Coordinates<d> home{};              ///< where that was
    Scope scope = Scope::expired;
    std::vector<Index> failed;          ///< those that left their tolerances; without tolerances those that move
    std::vector<Before> before;         ///< of these
    std::vector<Index> anchored;        ///< their fixed position is the goal by now
    std::vector<Renewal<d>> renewals;
    std::uint64_t tours = 0;            ///< vertices all of whose certificates were looked at
    double most = 0.0;                  ///< what repair may cost, in cells looked at
    double prepared = 0.0;              ///< the price of looking for what expired
    double rebuilding = 0.0;            ///< that of the rebuild, if there was one
    bool rebuilt = false;

    /// As new, with the memory of a step that is over.
    static Step recycled(Step& over, std::span<const Coordinates<d>> x, Index mover, Scope scope) {
        Step step = std::move(over);
        step.x = x;
        step.mover = mover;
        step.scope = scope;
        step.failed.clear();
        step.before.clear();
        step.anchored.clear();
        step.renewals.clear();
        step.tours = 0;
        step.most = step.prepared = step.rebuilding = 0.0;
        step.rebuilt = false;
        return step;
    }
};

}  // namespace annulus
