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
    /// False where no unimodular matrix relates the lattices, nearly. The old places must outlive the motion. O(n).
    [[nodiscard]] bool begin(const Periodic_points<d>& from, const Periodic_points<d>& to);
    /// False where the lattices and all places are the same.
    [[nodiscard]] bool moves() const { return moves_; }
    [[nodiscard]] std::span<const Coordinates<d>> home() const { return home_; }
    [[nodiscard]] std::span<Coordinates<d>> goal() { return goal_; }
    /// Whether offsets are others at home than at the old places.
    [[nodiscard]] bool relabels_home() const { return basis_.differs || mapped_.wraps; }
    /// Whether the bases are different vectors.
    [[nodiscard]] bool changes_box() const { return home_.data() == mapped_.place.data(); }
    /// The vertices whose goals are not their new places: offsets in their cells are others there.
    [[nodiscard]] std::span<const Index> wrapped() const { return wrapped_; }
    /// By how much the offsets of its corners are greater there.
    [[nodiscard]] Offset<d> growth_at_goal(Index v) const { return to_goal_[static_cast<std::size_t>(v)]; }
    /// Makes offsets at the old places such for home. False where a cell is too long for them.
    [[nodiscard]] bool relabel_home(Periodic_table<d>& table) const;
    /// Makes offsets of these cells at the goals such for the new places, of each once. False where one is too long.
    [[nodiscard]] bool relabel_goal(Periodic_table<d>& table, std::span<const std::size_t> cells) const;

  private:
    [[nodiscard]] bool relate(const Lattice<d>& from, const Lattice<d>& to);
    void find_home(const Periodic_points<d>& from, const Lattice<d>& to);
    void find_goal(std::size_t v, const Lattice<d>& to);
    [[nodiscard]] bool transform(Offset<d>& o) const;

    struct Basis_change {
        typename Lattice<d>::Matrix to_new{};  ///< row j: old basis vector j as a combination of the new ones
        bool differs = false;
    };
    /// Home, where that is not the old places.
    struct Mapped {
        std::vector<Coordinates<d>> place;
        std::vector<Offset<d>> growth;  ///< by vertex: what the offsets of its corners grow by
        bool wraps = false;             ///< some do
    };
    Basis_change basis_;
    Mapped mapped_;
    std::span<const Coordinates<d>> home_;
    std::vector<Coordinates<d>> goal_;
    std::vector<Offset<d>> to_goal_;  // by vertex: what the offsets of its corners grow by
    std::vector<Index> wrapped_;      // vertices whose to_goal_ is not 0
    bool moves_ = false;
};

extern template class Periodic_motion<2>;
extern template class Periodic_motion<3>;

}  // namespace annulus::inline v1
