// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// What became of the vertices that a call was to move; the last five add up to the first.
struct Move_counts {
    std::uint64_t asked = 0;
    std::uint64_t within_tolerance = 0;  ///< proved by the tolerance alone (or at rest): nothing was evaluated
    std::uint64_t kept_in_place = 0;     ///< tolerance failed, the certificates were evaluated and hold
    std::uint64_t flipped = 0;           ///< a certificate was violated and flips repaired it
    std::uint64_t reinserted = 0;        ///< removed and inserted again
    std::uint64_t rebuilt = 0;           ///< the triangulation was rebuilt

    Move_counts& operator+=(const Move_counts& o) noexcept {
        asked += o.asked;
        within_tolerance += o.within_tolerance;
        kept_in_place += o.kept_in_place;
        flipped += o.flipped;
        reinserted += o.reinserted;
        rebuilt += o.rebuilt;
        return *this;
    }
    friend bool operator==(const Move_counts&, const Move_counts&) = default;
};

/// What a call cost. Not a stable interface: it follows the strategies, so members may go, come, and count otherwise
/// in the next version. Star walks, recomputations of tolerances, cost, and steps by tolerances or signs are counted
/// by `tolerances`, `tolerances-each`, `auto` and `in-place` alone; cost also where `paper` has to rebuild everything.
struct Move_statistics {
    Stage_counts arithmetic;            ///< stage that decided, per certificate evaluated
    std::uint64_t evaluated = 0;        ///< certificates evaluated
    std::uint64_t star_walks = 0;       ///< failed vertices all of whose certificates had to be tested
    std::uint64_t requeued = 0;         ///< paper: vertices queued because another vertex lowered their tolerance
    std::uint64_t flips = 0;            ///< flips that were kept
    std::uint64_t undone_flips = 0;     ///< flips that were undone because they led nowhere
    std::uint64_t tolerance_steps = 0;  ///< time steps that began with tolerances
    std::uint64_t sign_steps = 0;       ///< time steps that began with the signs of all certificates
    std::uint64_t rebuild_steps = 0;    ///< auto: time steps that were rebuilt at once
    std::uint64_t tolerance_recomputations = 0;  ///< times that all tolerances were computed
    double cost = 0.0;                           ///< of the call, in cells tested, by measured costs (cost_model.h)

    Move_statistics& operator+=(const Move_statistics& o) noexcept {
        arithmetic += o.arithmetic;
        evaluated += o.evaluated;
        star_walks += o.star_walks;
        requeued += o.requeued;
        flips += o.flips;
        undone_flips += o.undone_flips;
        tolerance_steps += o.tolerance_steps;
        sign_steps += o.sign_steps;
        rebuild_steps += o.rebuild_steps;
        tolerance_recomputations += o.tolerance_recomputations;
        cost += o.cost;
        return *this;
    }
    friend bool operator==(const Move_statistics&, const Move_statistics&) = default;
};

/// What a call of `move`, `move_all`, `insert` or `remove` changed.
struct Move_result {
    Move_counts moves;
    /// On request (Options::report_changes): the cells that came and those that went, d + 1 vertices per cell, -1 for
    /// the vertex at infinity. No cell is in both lists (a cell that was turned over is another one), except where
    /// all points are in a plane or on a line before or after the call: then the lists are every finite cell there is
    /// and there was (padded with -2, `none`).
    std::vector<Index> changed, gone;
    Move_statistics statistics;

    Move_result& operator+=(const Move_result& o) {
        moves += o.moves;
        changed.insert(changed.end(), o.changed.begin(), o.changed.end());
        gone.insert(gone.end(), o.gone.begin(), o.gone.end());
        statistics += o.statistics;
        return *this;
    }
};

}  // namespace annulus::inline v1
