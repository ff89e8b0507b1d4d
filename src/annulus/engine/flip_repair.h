// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/held_back.h>
#include <annulus/engine/sign_evaluator.h>
#include <annulus/kernel/cavity_retriangulator.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <vector>

namespace annulus {

/// What repair came to.
struct Repair_result {
    bool done = false;           ///< every certificate holds at the targets
    bool cells_rebuilt = false;  ///< cells were, after which the table may be pinched at infinity (docs/theory.md 6.5)
    std::uint64_t flips = 0;
    std::vector<Cell_index> touched;  ///< cells made or changed, some perhaps gone again, each once
    std::vector<Index> reinserted;    ///< vertices at which flips were stuck, so that cells around them were rebuilt
};

/// Leads a table that is Delaunay where its vertices come from to the one that is Delaunay where they go, by flips.
///
/// Where a cell is inverted at the targets one of its vertices is held back (Held_back). Violated facets of positive
/// cells are flipped. Then those held back go on from where they are, through the triangulation in which what stood
/// in their way has been flipped (docs/theory.md 6.3). At the hull, where half way is never outside, the cell that a
/// vertex turns over by leaving goes. What is still stuck after that is rebuilt locally (Cavity_retriangulator).
///
/// Nothing here is trusted: a certificate that is not known to hold is on a list of `signs` until it has been seen to
/// hold, at the targets, and repair is done when the lists are empty. Only the table changes.
template <int d>
class Flip_repair {
  public:
    /// Both must outlive it.
    Flip_repair(Delaunay_mesh<d>& mesh, Sign_evaluator<d>& signs)
        : table_(mesh.table()), signs_(signs), local_(mesh.table()) {}

    /// Nothing has been repaired.
    void begin();
    /// What is not known to hold at course.x is on the lists of signs, which began there. Not done: what was done costs
    /// more than the budget has, or led nowhere. The table is then of no use, as when it throws, until the cells that
    /// were touched are restored. On return course.x has the targets again.
    const Repair_result& repair(const Motion_path<d>& path, Budget& budget);
    /// Of repair(), since begin().
    [[nodiscard]] const Repair_result& result() const { return result_; }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    void run();
    [[nodiscard]] bool untangle_or_hold_back();
    [[nodiscard]] bool untangle(Cell_index c);
    [[nodiscard]] bool flip_violated();
    /// The flip that repairs a violated facet, of which h is a half, if there is one that leaves positive cells.
    [[nodiscard]] bool flip(Corner_index h);
    [[nodiscard]] bool finish_locally();
    void note_stuck(std::vector<Cell_index>& seeds);
    void made(std::span<const Cell_index> cells);
    void moved(Index v);
    [[nodiscard]] bool nothing_inverted();

    /// What the lists of signs do not hold.
    struct Left {
        std::vector<Cell_index>
            inverted_at_source;           // cells that are inverted with all their vertices where they come from
        std::vector<Corner_index> stuck;  // facets that no flip repairs
        std::vector<Corner_index> waiting;
    };

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

}  // namespace annulus
