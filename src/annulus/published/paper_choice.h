// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/options.h>

// The sections of the paper and the files that implement them. The paper is P. M. M. de Castro, J. Tournois, P. Alliez,
// O. Devillers, Filtering Relocations on a Delaunay Triangulation, Computer Graphics Forum 28(5), 2009.
//
//   2.2, 2.3  certificates, standard annuli      standard_annulus.h
//   2.3       delimiters, for safe regions       delimiter_side.h
//   2.3       tolerances of vertices             paper_tolerances.h, least_tolerance.h
//   3.1       relocation: in place, flips        relocation.h, lawson_flips.h; as a strategy relocation_strategy.h
//   3.2       filtering algorithm and its queue  paper_strategy.h, paper_strategy.cpp
//   4.2       switch from rebuilding             paper_switch.cpp
//
// What the engine requires of every strategy (starting, insertions, transactions) is in paper_strategy_state.cpp. The
// paper's tolerances are unsound in 3D: docs/theory.md 3.
namespace annulus::inline v1 {

/// Which variant of the paper's algorithms. Four of them are strategies of the library.
struct Paper_choice {
    bool tolerances = true;      ///< the filtering algorithm (3.2); otherwise every vertex is relocated
    bool in_place = true;        ///< 3.1, "weaker version": a vertex is relocated only where cells have to change
    bool flips = true;           ///< 3.1, in 2D: flips instead of relocation if no triangle is inverted
    bool safe_region = false;    ///< 3.2, in 2D: a vertex beyond its tolerance stays while it is in its safe region
    bool rebuild_first = false;  ///< 4.2: rebuilds until the motion is slow enough for tolerances

    /// Precondition: one of `relocate`, `relocate_flips`, `paper`, `paper_hybrid`.
    [[nodiscard]] static constexpr Paper_choice of(Strategy strategy) {
        switch (strategy) {
            case Strategy::relocate: return {.tolerances = false, .in_place = false, .flips = false};
            case Strategy::relocate_flips: return {.tolerances = false, .flips = false};
            case Strategy::paper_hybrid: return {.rebuild_first = true};
            default: return {};
        }
    }
    /// The strategy of the library that this choice is; if it is none of these, the one that is most similar.
    [[nodiscard]] constexpr Strategy strategy() const {
        if (tolerances) return rebuild_first ? Strategy::paper_hybrid : Strategy::paper;
        return in_place || flips ? Strategy::relocate_flips : Strategy::relocate;
    }
};

}  // namespace annulus::inline v1
