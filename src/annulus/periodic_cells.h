// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/box.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// The cells of a periodic triangulation, one of each set of translates, numbered 0, 1, 2 .., and their adjacency.
template <int d>
struct Periodic_cells {
    static constexpr std::size_t corners = d + 1;
    /// The vertices of each cell, positively oriented (mesh_cells.h). A vertex may occur several times.
    std::vector<std::array<Index, corners>> vertices;
    /// Which image of the vertex a corner is: corner k of cell c is at points[vertices[c][k]] + offsets[c][k] . box.
    /// The least offset of a cell is 0 in each direction.
    std::vector<std::array<Shift<d>, corners>> offsets;
    /// The cell beyond the facet opposite to each corner, never the cell itself. Two cells may share several facets.
    std::vector<std::array<Index, corners>> neighbours;
    /// What to add to the offsets of that cell, so that the images of the common facet are the same.
    std::vector<std::array<Shift<d>, corners>> translations;
};

/// The Voronoi facets of points in a periodic box: an entry for each ordered pair of neighbouring images, in ascending
/// order of (first, second, shift). A pair is there in both directions; a point may be its own neighbour, and two
/// points neighbours several times, with different shifts.
template <int d>
struct Periodic_neighbours {
    std::vector<Index> first, second;
    /// Which image of the second point it is: vector = points[second] - points[first] + shift . box.
    std::vector<Shift<d>> shift;
    std::vector<Coordinates<d>> vector;  ///< exact
    std::vector<double> distance;        ///< its length, rounded
    /// The length (2D) or area (3D) of the common facet of the Voronoi cells. 0 where that is exactly empty, or a
    /// point, or in 3D an edge, and only there: as in a cubic crystal, whose cells touch in points and edges, too.
    std::vector<double> area;
};

/// The input of an audit of a periodic triangulation, nothing derived. Coordinates are taken as they are, and offsets
/// in the box's vectors, in integers: nothing is rounded.
template <int d>
struct Periodic_audit_input {
    std::vector<Coordinates<d>> points;
    typename Box<d>::Vectors box;
    /// `neighbours` and `translations` may be left empty: then the gluing alone is examined that the cells imply.
    Periodic_cells<d> cells;
    std::size_t most_faults = 0;  ///< how many faults to list, beside counting all
};

/// Exact verdict on a periodic triangulation: every cell is positive; every facet belongs to two cells, up to a
/// translation, on different sides; the volumes of the cells add up to that of the box; every vertex has a cell; no
/// opposite vertex is strictly inside the sphere of a bi-cell; neighbours and translations, if given, are those of the
/// facets. By docs/theory.md 8.3 these suffice. Cospherical points are no fault (degenerate_facets). Integers
/// throughout, by code of its own. In the result `overlap` also says that the cells cover the box several times, and
/// `hull_broken` that a facet has no other side, or another one than is said. O(n log n), some microseconds a cell.
/// Preconditions: finite coordinates, offsets below 2^29. Throws wrong_size where the arrays of the cells differ in
/// length.
[[nodiscard]] Audit_result audit(const Periodic_audit_input<2>& input);
[[nodiscard]] Audit_result audit(const Periodic_audit_input<3>& input);

}  // namespace annulus::inline v1
