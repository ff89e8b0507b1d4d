// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/held_back.h>
#include <annulus/engine/periodic_motion.h>
#include <annulus/engine/periodic_signs.h>
#include <annulus/engine/periodic_tolerances.h>
#include <annulus/mesh/periodic_journal.h>
#include <annulus/mesh/periodic_star.h>
#include <annulus/mesh/replace_periodic_cells.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// What became of a table.
struct Periodic_repair_result {
    bool done = false;           ///< it is the triangulation of the new points; otherwise it is as it was
    bool by_tolerances = false;  ///< only certificates that had expired were tested
    std::uint64_t flips = 0;
    std::size_t flipped = 0;  ///< vertices of cells that flips made
    std::size_t failed = 0;   ///< of the others, those that left their tolerances
    Stage_counts evaluated;
};

/// Turns the periodic Delaunay triangulation of points into the one of the same points elsewhere, in another box, too:
/// Flip_repair for cells with offsets (docs/theory.md 8.7).
///
///     all signs at the goals, or those of what has expired  -- all hold -->  the table is right as it is
///           |
///     hold back, flip, advance  -- lists are empty -->  proved (is_still_proved_delaunay), or it does not count
///
/// There is no border, so that half way is never outside. What is stuck, and what would cost more than the budget, is
/// left to the caller, which rebuilds: nothing is rebuilt locally. Flips are made in the table itself; a journal undoes
/// them, and says what there is to prove.
template <int d>
class Periodic_repair {
  public:
    struct Tolerances {
        Periodic_tolerances<d>& of;
        std::size_t most_failed;
    };
    /// The most threads, 1 at first. Results do not depend on it.
    void set_threads(int threads) { signs_.set_threads(threads); }
    /// The table is that of `from`, proved; with result.done it is that of `to`. Where only signs were needed, cells
    /// keep their numbers. With tolerances that are kept, and that at most so many vertices have left, only what has
    /// expired is tested, and they are kept at the end; where anything ends otherwise none are. Throws bad_alloc, with
    /// the table as it was.
    Periodic_repair_result repair(Periodic_table<d>& table, const Periodic_points<d>& from,
                                  const Periodic_points<d>& to, Budget& budget, const Tolerances& tolerances);
    /// The last one.
    [[nodiscard]] Periodic_motion<d>& motion() { return motion_; }

  private:
    class Change;
    /// Cells with failures that are not on the lists of signs.
    struct Left {
        std::vector<std::size_t> inverted_at_source;
        std::vector<Corner_index> stuck, waiting;  // facets that no flip repairs, at present
        std::vector<std::size_t> doubted;          // what was inverted or violated at the goals, before all flips
    };
    /// What flips have made.
    struct Made {
        Periodic_journal<d> journal;  // of it and of what changed offsets
        std::uint64_t flips = 0;
        std::vector<std::uint8_t> flipped;        // by vertex: whether it is in a cell that a flip made
        std::vector<std::size_t> unused, latest;  // numbers of no cell, and the cells of the latest flip
    };

    [[nodiscard]] bool is_cell(std::size_t c) const { return work_.vertex[c][0] != none; }
    [[nodiscard]] bool test_expired(Periodic_tolerances<d>& tolerances, const Lattice<d>& lattice,
                                    Stage_counts& counts);
    void keep_tolerances(Periodic_tolerances<d>& tolerances, const Periodic_points<d>& to, bool calm,
                         Stage_counts& counts);
    void count_outcomes(Periodic_repair_result& result, const Periodic_tolerances<d>& tolerances, bool calm) const;
    void note_doubted();
    void close_gaps();
    [[nodiscard]] bool relabel_goal();
    [[nodiscard]] bool flip_until_done(const Lattice<d>& lattice);
    [[nodiscard]] bool hold_back_inverted();
    [[nodiscard]] bool flip_violated();
    /// Makes the flip that repairs a violated facet, of which h is a half, if there is one whose cells are positive.
    [[nodiscard]] bool flip(Corner_index h);
    [[nodiscard]] bool replace(std::span<const Lifted_cell<d>> gone, std::span<const Cell_images<d>> came);
    [[nodiscard]] bool nothing_inverted();
    void moved(Index v);

    Periodic_motion<d> motion_;
    Periodic_signs<d> signs_;
    Held_back<d> held_;
    Left left_;
    Periodic_table<d> work_;  // the table, while it is repaired
    Periodic_star<d> star_;
    Made made_;
    Budget* budget_ = nullptr;
};

// What the dimensions do not share: periodic_repair_flip.cpp.
template <>
bool Periodic_repair<2>::flip(Corner_index h);
template <>
bool Periodic_repair<3>::flip(Corner_index h);

extern template class Periodic_repair<2>;
extern template class Periodic_repair<3>;

}  // namespace annulus::inline v1
