// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// A side of a convex polygon or polytope: an edge or a face.
template <int d>
struct Cell_side {
    Index label;
    double measure;           ///< length or area
    Coordinates<d> centroid;  ///< some corner of it where the measure is 0
};

/// A side by its corners, in order, counter-clockwise seen from outside; in 2D the two ends, the cell on the left.
struct Cell_face {
    Index label;
    std::vector<std::size_t> corners;
};

template <int d>
struct Cell_content {
    double volume;
    Coordinates<d> centroid;  ///< NaN where the volume is 0
};

/// A box of which half-spaces cut off parts, in doubles. Each corner is computed once and shared by its sides, so that
/// the surface stays closed: with corners a small distance from their planes, the volume is off by that distance times
/// the surface, however the planes meet.
template <int d>
class Convex_cell {
  public:
    Convex_cell(const Coordinates<d>& lower, const Coordinates<d>& upper, Index label);
    /// Cuts off the positions x with normal . x > offset; `label` names the side that this makes. A side in the plane
    /// itself keeps its label. O(corners).
    void cut(const Coordinates<d>& normal, double offset, Index label);

    [[nodiscard]] bool is_empty() const { return sides_.empty(); }
    /// Ones with the same label may be adjacent.
    [[nodiscard]] std::vector<Cell_side<d>> sides() const;
    [[nodiscard]] const std::vector<Coordinates<d>>& corners() const { return corner_; }
    /// The same sides; corners by number.
    [[nodiscard]] const std::vector<Cell_face>& faces() const { return sides_; }
    [[nodiscard]] Cell_content<d> content() const;
    /// The least and the largest coordinates. Precondition: not empty.
    [[nodiscard]] std::pair<Coordinates<d>, Coordinates<d>> bounds() const;

  private:
    using Side = Cell_face;
    [[nodiscard]] std::size_t crossing(std::size_t inside, std::size_t outside);
    void close(const std::vector<std::pair<std::size_t, std::size_t>>& gaps, Index label);
    void drop_unused();

    std::vector<Coordinates<d>> corner_;
    std::vector<Side> sides_;
    std::vector<double> beyond_;  // of each corner how far it is beyond the plane of a cut, times |normal|
    std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> made_;  // edges cut, and the new corner
};

extern template class Convex_cell<2>;
extern template class Convex_cell<3>;

}  // namespace annulus::inline v1
