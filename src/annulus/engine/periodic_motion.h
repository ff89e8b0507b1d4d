// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The points of a periodic box, by their representatives.
template <int d>
struct Periodic_points {
    const Lattice<d>& lattice;
    std::span<const Coordinates<d>> place;
};

/// How points get from one box to the next, as places of the new lattice (docs/theory.md 8.7).
///
///     place, old lattice  --affine map, relabelled-->  home  --straight-->  goal  --relabelled-->  place, new lattice
///
/// The affine map takes the old basis to the new one, as vectors: cells that were positive are positive at home, up to
/// rounding. The goal of a point is the image of its new place that is nearest to its home.
template <int d>
class Periodic_motion {
  public:
    /// False where no unimodular matrix relates the lattices, nearly. O(n).
    [[nodiscard]] bool begin(const Periodic_points<d>& from, const Periodic_points<d>& to);
    [[nodiscard]] std::span<const Coordinates<d>> home() const { return home_; }
    [[nodiscard]] std::span<Coordinates<d>> goal() { return goal_; }
    /// Whether offsets are others at home than at the old places, and at the new places than at the goals.
    [[nodiscard]] bool relabels_home() const { return other_basis_ || wraps_home_; }
    [[nodiscard]] bool relabels_goal() const { return wraps_goal_; }
    /// Makes offsets at the old places such for home, or offsets at the goals such for the new places. False where a
    /// cell is too long for them.
    [[nodiscard]] bool relabel_home(Periodic_table<d>& table) const;
    [[nodiscard]] bool relabel_goal(Periodic_table<d>& table) const;

  private:
    [[nodiscard]] bool relate(const Lattice<d>& from, const Lattice<d>& to);
    [[nodiscard]] bool transform(Offset<d>& o) const;

    std::vector<Coordinates<d>> home_, goal_;
    std::vector<Offset<d>> to_home_, to_goal_;    // by vertex: what the offsets of its corners grow by
    typename Lattice<d>::Matrix to_new_basis_{};  // row j: old basis vector j as a combination of the new ones
    bool other_basis_ = false, wraps_home_ = false, wraps_goal_ = false;
};

extern template class Periodic_motion<2>;
extern template class Periodic_motion<3>;

}  // namespace annulus::inline v1
