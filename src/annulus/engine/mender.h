// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/budget.h>
#include <annulus/engine/held_back.h>
#include <annulus/engine/signs.h>
#include <annulus/kernel/cavity_retriangulator.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <vector>

namespace annulus {

/// What mending came to.
struct Mending {
    bool done = false;        ///< every certificate holds at the goals
    bool built_anew = false;  ///< cells were, after which the table may be pinched at infinity (docs/theory.md 6.5)
    std::uint64_t flips = 0;
    std::vector<Cell_index> touched;  ///< cells made or changed, some perhaps gone again, each once
    std::vector<Index> reinserted;    ///< vertices at which flips were stuck, so that cells around them were rebuilt
};

/// Leads a table that is Delaunay where its vertices come from to the one that is Delaunay where they go, by flips.
///
/// Where a cell is inverted at the goals one of its vertices is held back (Held_back). Violated facets of positive
/// cells are flipped. Then those held back go on from where they are, through the triangulation in which what stood
/// in their way has been flipped (docs/theory.md 6.3). At the hull, where half way is never outside, the cell that a
/// vertex turns over by leaving goes. What is still stuck after that is rebuilt locally (Cavity_retriangulator).
///
/// Nothing here is trusted: a certificate that is not known to hold is on a list of `signs` until it has been seen to
/// hold, at the goals, and mending is done when the lists are empty. Only the table changes.
template <int d>
class Mender {
  public:
    /// Both must outlive it.
    Mender(Delaunay_mesh<d>& mesh, Signs<d>& signs) : table_(mesh.table()), signs_(signs), local_(mesh.table()) {}

    /// Nothing has been mended.
    void begin();
    /// What is not known to hold at course.x is on the lists of signs, which began there. Not done: what was done costs
    /// more than the budget has, or led nowhere. The table is then of no use, as when it throws, until the cells that
    /// were touched are restored. On return course.x has the goals again.
    const Mending& mend(const Course<d>& course, Budget& budget);
    /// Of mend(), since begin().
    [[nodiscard]] const Mending& result() const { return result_; }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    void run();
    [[nodiscard]] bool unfold_or_hold();
    [[nodiscard]] bool unfold(Cell_index c);
    [[nodiscard]] bool flip_violated();
    /// The flip that mends a violated facet, of which h is a half, if there is one that leaves positive cells.
    [[nodiscard]] bool flip(Corner_index h);
    [[nodiscard]] bool finish_locally();
    void note_stuck(std::vector<Cell_index>& seeds);
    void made(std::span<const Cell_index> cells);
    void moved(Index v);
    [[nodiscard]] bool nothing_inverted();

    /// What the lists of signs do not hold.
    struct Left {
        std::vector<Cell_index> folded;   // cells that are inverted with all their vertices where they come from
        std::vector<Corner_index> stuck;  // facets that no flip mends
        std::vector<Corner_index> waiting;
    };

    Corner_table<d>& table_;
    Signs<d>& signs_;
    Cavity_retriangulator<d> local_;
    Held_back<d> held_;
    Left left_;
    Mending result_;
    Budget* budget_ = nullptr;
};

// What the dimensions do not share: mender_2.cpp, mender_3.cpp.
template <>
bool Mender<2>::unfold(Cell_index c);
template <>
bool Mender<2>::flip(Corner_index h);
template <>
bool Mender<3>::unfold(Cell_index c);
template <>
bool Mender<3>::flip(Corner_index h);

extern template class Mender<2>;
extern template class Mender<3>;

}  // namespace annulus
