// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/held_back.h>
#include <annulus/engine/sign_evaluator.h>
#include <annulus/kernel/cavity_retriangulator.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <vector>

namespace annulus::inline v1 {

/// The result of a repair.
struct Repair_result {
    bool done = false;           ///< every certificate holds at the targets
    bool cells_rebuilt = false;  ///< afterwards the table may be pinched at infinity (docs/theory.md 6.5)
    std::uint64_t flips = 0;
    std::vector<Cell_index> touched;  ///< cells made or changed, each once; some may be gone again
    std::vector<Index> reinserted;    ///< vertices at which flips got stuck, so that cells around them were rebuilt
};

/*
         a                  a
        / \                /|\         x inside abc, 2-3: the facet abc makes way for the edge pq;
       /   \       2-3    / | \        the cells abcp, abcq become abpq, bcpq, capq
      /  x  \      -->   /  x  \
     /       \          / .' '. \
    b---------c        b---------c

         a                  a
        / \                /|\         x beyond bc, 3-2: the edge bc makes way for the facet apq;
       /   \       3-2    / | \        the cells abcp, abcq, bcpq become abpq, capq
      b-----c      -->   b  |  c
       \   /              \ | /        (a 2-2 flip in 2D looks the same, with a vertex at x)
        \ /                \|/
         x                  x
*/
/// Turns a table that is Delaunay at the sources of its vertices into the one that is Delaunay at their targets, by
/// flips.
///
/// Where a cell is inverted at the targets, one of its vertices is held back (Held_back). Violated facets of positive
/// cells are flipped. Then the vertices held back advance from where they are, in the triangulation in which the
/// facets in their way have been flipped (docs/theory.md 6.3). At the hull half way is never outside; there a flip
/// removes the cell that a vertex inverts by leaving (6.4). What is still stuck after that is rebuilt locally
/// (Cavity_retriangulator). In a time step, vertices for which further rounds would not pay (Late_rounds) are removed
/// and inserted again at their targets.
///
/// In 2D a flip (2-2) exchanges the diagonals of a bi-cell. In 3D the flip depends on the point x where the edge pq
/// of the two opposite vertices meets the plane of the facet abc. The pictures show this plane; q is above it, p
/// below.
///
/// Nothing here is trusted: a certificate that is not known to hold stays on a list of `signs` until its sign at the
/// targets has shown that it holds, and repair is done when the lists are empty. Only the table changes.
template <int d>
class Flip_repair {
  public:
    /// Both must outlive it.
    Flip_repair(Delaunay_mesh<d>& mesh, Sign_evaluator<d>& signs)
        : mesh_(mesh), table_(mesh.table()), signs_(signs), local_(mesh.table()) {}

    /// Starts with nothing repaired.
    void begin();
    /// The certificates that are not known to hold at path.x are on the lists of signs, which began there. Not done:
    /// the work has cost more than the budget, which in a time step is raised to Rebuild_policy::late_limit() after the
    /// first round, or led nowhere. Then, as when it throws, the table is of no use until
    /// the cells that were touched are restored. On return path.x has the targets again.
    const Repair_result& repair(const Motion_path<d>& path, Budget& budget);
    /// The result of repair(), since begin().
    [[nodiscard]] const Repair_result& result() const { return result_; }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    void run();
    [[nodiscard]] bool untangle_or_hold_back();
    [[nodiscard]] bool untangle(Cell_index c);
    [[nodiscard]] bool flip_violated();
    /// Makes the flip that repairs a violated facet, of which h is a half, if there is one whose cells are positive.
    [[nodiscard]] bool flip(Corner_index h);
    [[nodiscard]] bool finish_locally();
    void note_stuck(std::vector<Cell_index>& seeds);
    void made(std::span<const Cell_index> cells);
    void moved(Index v);
    [[nodiscard]] bool nothing_inverted();

    // flip_repair_reinsert.cpp
    bool test_touched(std::size_t first);
    [[nodiscard]] bool stars_are_whole(std::size_t first) const;
    [[nodiscard]] bool rebuild_stuck();
    [[nodiscard]] double cost_of_reinsertion() const;
    [[nodiscard]] bool reinsert_held();

    /// Failures that are not on the lists of signs.
    struct Left {
        std::vector<Cell_index> inverted_at_source;  // cells inverted with all vertices at their sources
        std::vector<Corner_index> stuck;             // facets that no flip repairs
        std::vector<Corner_index> waiting;
    };

    Delaunay_mesh<d>& mesh_;
    Corner_table<d>& table_;
    Sign_evaluator<d>& signs_;
    Cavity_retriangulator<d> local_;
    Held_back<d> held_;
    Left left_;
    Repair_result result_;
    Budget* budget_ = nullptr;
};

// What the dimensions do not share: flip_repair_2.cpp, flip_repair_3.cpp.
template <>
bool Flip_repair<2>::untangle(Cell_index c);
template <>
bool Flip_repair<2>::flip(Corner_index h);
template <>
bool Flip_repair<3>::untangle(Cell_index c);
template <>
bool Flip_repair<3>::flip(Corner_index h);

extern template class Flip_repair<2>;
extern template class Flip_repair<3>;

}  // namespace annulus::inline v1
