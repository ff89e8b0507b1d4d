// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <annulus/voronoi.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Voronoi cells that are intersected with a clip, as polygons (2D) or polyhedra (3D).
template <int d>
struct Voronoi_polytopes {
    /// The corners of all cells; each cell has its own.
    std::vector<Coordinates<d>> corner;
    /// The sides of the cell of vertex v are side_begin[v] to side_begin[v + 1] - 1; none at a free index, and where
    /// the cell is outside the clip.
    std::vector<Index> side_begin;
    /// By side: the vertex whose cell is beyond it, -1 for the border of the clip. A neighbour may have more than one
    /// side where rounding has folded it.
    std::vector<Index> neighbour;
    /// The corners of side s are side_corner[corner_begin[s]] to side_corner[corner_begin[s + 1] - 1], numbers of
    /// `corner`. In 2D two, the end of each side of a cell being the beginning of the next one, counter-clockwise; in
    /// 3D counter-clockwise seen from outside.
    std::vector<Index> corner_begin, side_corner;
};

/// Cuts the cells of all vertices out of the clip, in doubles, from their neighbours in the Delaunay triangulation;
/// a point that is not a number is none. Method and errors are those of voronoi_diagram for cells that are not inside
/// the clip: with L the diameter of clip and points, a volume is off by at most 2^-44 L^d, and each cell is closed.
/// Corners of neighbouring cells are computed for each, and agree up to rounding. Sides towards vertices whose cells
/// meet this one in less than a facet may be there, with a measure that is 0 or nearly so, or not.
///
/// O(n): some microseconds per vertex in 2D, some ten in 3D. Throws bad_input, not_finite for a clip, too_large for
/// 2^31 corners.
template <int d>
[[nodiscard]] Voronoi_polytopes<d> voronoi_polytopes(std::span<const Coordinates<d>> points,
                                                     const Vertex_neighbours& neighbours, const Voronoi_clip<d>& clip);

extern template Voronoi_polytopes<2> voronoi_polytopes<2>(std::span<const Coordinates<2>>, const Vertex_neighbours&,
                                                          const Voronoi_clip<2>&);
extern template Voronoi_polytopes<3> voronoi_polytopes<3>(std::span<const Coordinates<3>>, const Vertex_neighbours&,
                                                          const Voronoi_clip<3>&);

}  // namespace annulus::inline v1
