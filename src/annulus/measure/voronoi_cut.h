// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/clip_planes.h>
#include <annulus/measure/convex_cell.h>
#include <annulus/measure/voronoi_facet_exact.h>
#include <annulus/voronoi.h>

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The part of a Voronoi cell that is in a clip, in the unit 2^exponent of its Voronoi_cut.
template <int d>
struct Cut_cell {
    Cell_content<d> content;  ///< centroid relative to the vertex
    double surface = 0;
    std::vector<Cell_side<d>> facets;  ///< by neighbours in the order of Voronoi_cut::neighbours; measure 0 outside
};

/// Intersects Voronoi cells with a clip, in doubles: from the box of the clip, made larger, the bisectors of a vertex
/// and its neighbours cut off their parts, and then the box itself and the half-spaces of the clip. Refers to the
/// points.
template <int d>
class Voronoi_cut {
  public:
    /// `pairs` are all neighbours i < j, ascending. Throws bad_input and not_finite for a clip.
    Voronoi_cut(std::span<const Coordinates<d>> points, std::span<const std::array<Index, 2>> pairs,
                const Voronoi_clip<d>& clip);

    /// Whether a position is in the clip's interior, if each coordinate of it may be off by `error`.
    [[nodiscard]] bool is_inside(const Coordinates<d>& x, double error) const;
    [[nodiscard]] std::span<const Index> neighbours(Index v) const;
    [[nodiscard]] Cut_cell<d> cell(Index v) const;
    /// The same with corners, relative to the vertex. Labels are places in neighbours(v); -1 for the clip's border.
    [[nodiscard]] Convex_cell<d> polytope(Index v) const;
    /// A measure of a Cut_cell in the caller's unit to this power; the largest double for what is larger.
    [[nodiscard]] double measure(double in_unit, int power) const;
    /// A position in the cell of v in the caller's unit.
    [[nodiscard]] Coordinates<d> position(Index v, const Coordinates<d>& from_v) const;

  private:
    [[nodiscard]] Coordinates<d> difference(const Coordinates<d>& a, const Coordinates<d>& b) const;

    std::span<const Coordinates<d>> x_;
    Coordinates<d> lower_, upper_;
    std::vector<Clip_plane<d>> planes_;
    std::vector<std::size_t> begin_;
    std::vector<Index> index_;
    int exponent_;
};

extern template class Voronoi_cut<2>;
extern template class Voronoi_cut<3>;

}  // namespace annulus::inline v1
