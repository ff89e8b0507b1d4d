// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/limits.h>
#include <annulus/engine/budget.h>
#include <annulus/engine/expiry_list.h>
#include <annulus/engine/vertex_record.h>
#include <annulus/internal/index.h>
#include <annulus/types.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Which certificates a step evaluates: those that expired; or, without tolerances, all those of the vertex that
/// moves, or all.
enum class Scope : std::uint8_t { expired, star, everything };

/// One or one and a half cache lines: a vertex has 12 certificates in 2D, 80 in 3D.
template <int d>
using Vertex_expiries = Expiry_list<Limits::listed(d)>;

/// A step in progress: where vertices go, what it may cost, and what each stage hands to the next: which vertices
/// left their tolerances, what was violated and repaired, what is to be written down. An exception drops it.
template <int d>
struct Step {
    /// The state of a vertex before it is anchored.
    struct Before {
        Vertex_record<d> record;
        Vertex_expiries<d> list;
    };

    std::span<const Coordinates<d>> x;  ///< targets, by vertex
    Index mover = none;                 ///< the vertex that moves alone
    Coordinates<d> source{};            ///< where it was
    Scope scope = Scope::expired;
    std::vector<Index> failed;     ///< those that left their tolerances; without tolerances those that move
    std::vector<Before> before;    ///< of these
    std::vector<Index> anchored;   ///< vertices whose fixed position is the target by now
    std::uint64_t star_walks = 0;  ///< vertices all of whose certificates were tested
    Budget budget;                 ///< for everything that the step does
    Move_result report;            ///< what was evaluated and flipped

    // What Repair found and did.
    bool infeasible = false;             ///< repair would cost far more than it may, judging by a sample
    std::vector<Index> affected;         ///< points of violated certificates
    std::vector<Index> reinserted;       ///< vertices around which cells were rebuilt
    std::vector<Cell_index> renumbered;  ///< as before a duplicate point was found, but with other numbers
    bool rebuilt = false;
    bool renumbered_all = false;  ///< the same of all cells

    /// These certificates or signs were evaluated.
    void count(const Stage_counts& counts) {
        report.statistics.evaluated += counts.total();
        report.statistics.arithmetic += counts;
    }
    /// Forgets what an examination found.
    void clear_findings() {
        report = {};
        infeasible = false;
        affected.clear();
        reinserted.clear();
        renumbered.clear();
    }

    /// A fresh step that reuses the memory of a finished one.
    static Step recycled(Step& over, std::span<const Coordinates<d>> x, Index mover, Scope scope) {
        Step step = std::move(over);
        step.x = x;
        step.mover = mover;
        step.scope = scope;
        step.failed.clear();
        step.before.clear();
        step.anchored.clear();
        step.star_walks = 0;
        step.budget = {};
        step.clear_findings();
        step.rebuilt = step.renumbered_all = false;
        return step;
    }
};

}  // namespace annulus::inline v1
