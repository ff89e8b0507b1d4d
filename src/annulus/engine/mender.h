// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/local_delaunay.h>
#include <annulus/engine/signs.h>
#include <annulus/kernel/delaunay_mesh.h>

#include <span>
#include <vector>

namespace annulus {

/// From where to where vertices move.
template <int d>
struct Course {
    /// The goals of all vertices, at the beginning and at the end; in between those that are held back are elsewhere.
    std::span<Coordinates<d>> x;
    /// Where all vertices come from. Empty when one alone moves.
    std::span<const Coordinates<d>> home{};
    Index mover = none;  ///< that one
    Coordinates<d> mover_home{};

    [[nodiscard]] const Coordinates<d>& home_of(Index v) const {
        const auto i = static_cast<std::size_t>(v);
        return v == mover ? mover_home : home.empty() ? x[i] : home[i];
    }
};

/// Leads a table that is Delaunay where its vertices come from to the one that is Delaunay where they go, by flips.
///
/// Where a cell is inverted at the goals one of its vertices is held back: half the way, then all of it. Violated facets of positive
/// cells are flipped. Then those held back go on from where they are, through the triangulation in which what stood in their way has
/// been flipped (docs/theory.md 6.3). At the hull, where half way is never outside, the cell that a vertex turns over by leaving goes.
/// What is still stuck after that is built anew locally (Local_delaunay).
///
/// Nothing here is trusted: a certificate that is not known to hold is on a list until it has been seen to hold, at the goals, and
/// `mend` answers true when the lists are empty. Only the table changes.
template <int d>
class Mender {
  public:
    explicit Mender(Delaunay_mesh<d>& mesh) : table_(mesh.table()), signs_(table_), local_(mesh.table()) {}

    /// Starts an examination at the goals x. The lists of signs() are to be filled with what is not known to hold there, before mend().
    void begin(std::span<const Coordinates<d>> x);
    [[nodiscard]] Signs<d>& signs() { return signs_; }
    void set_threads(int threads) { signs_.set_threads(threads); }

    /// False: what was done cost `most` (in cells looked at) or led nowhere. The table is then of no use, as when it throws, until the cells
    /// that were touched are restored. On return course.x has the goals again.
    [[nodiscard]] bool mend(const Course<d>& course, double most);

    /// Cells made or changed, some perhaps gone again, each once. Of mend().
    [[nodiscard]] const std::vector<Cell_index>& touched() const { return touched_; }
    /// Whether cells were built anew, after which T may be pinched at infinity (docs/theory.md 6.5).
    [[nodiscard]] bool built_anew() const { return built_anew_; }
    /// Vertices at which flips were stuck, so that the cells around them were built anew.
    [[nodiscard]] const std::vector<Index>& reinserted() const { return reinserted_; }
    [[nodiscard]] std::uint64_t flips() const { return flips_; }
    /// What it cost so far, in cells looked at.
    [[nodiscard]] double price() const { return signs_.price() + price_; }

  private:
    struct Held {
        Index vertex;
        Coordinates<d> home;  // of this round
        Coordinates<d> goal;
        double share;  // of the way from there to the goal, that is tried
        int times;     // held back in this round
    };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] bool affordable() const { return price() <= most_; }
    [[nodiscard]] bool unfold_or_hold();
    [[nodiscard]] bool unfold(Cell_index c);
    [[nodiscard]] bool hold_back(Cell_index c);
    [[nodiscard]] bool flip_violated();
    /// The flip that mends a violated facet, of which h is a half, if there is one that leaves positive cells.
    [[nodiscard]] bool flip(Corner_index h);
    /// Whether anybody got nearer to the goal, or there.
    [[nodiscard]] bool go_on();
    [[nodiscard]] bool finish_locally();
    void place(Index v, const Coordinates<d>& p);
    void release();
    void made(std::span<const Cell_index> cells);
    [[nodiscard]] bool nothing_inverted();

    Cell_table<d>& table_;
    Signs<d> signs_;
    Local_delaunay<d> local_;
    Course<d> course_;
    double most_ = 0.0;
    bool first_round_ = true;  // nobody has gone on yet
    bool built_anew_ = false;
    double price_ = 0.0;
    std::uint64_t flips_ = 0;
    std::vector<Held> held_;
    std::vector<Index> place_of_;  // by vertex: 1 + its place in held_, 0 when it is not held
    std::vector<Cell_index> folded_;   // cells that are inverted with all their vertices where they come from
    std::vector<Corner_index> stuck_;  // facets that no flip mends
    std::vector<Corner_index> waiting_;
    std::vector<Cell_index> touched_;
    std::vector<Index> reinserted_;
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
