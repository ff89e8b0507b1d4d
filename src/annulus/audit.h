// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// The input of an audit: points and finite cells, nothing derived.
template <int d>
struct Audit_input {
    std::vector<Coordinates<d>> points;
    /// d + 1 indices into `points` for each cell, positively oriented. When the points span only a lower dimension k <
    /// d: the k-simplices, padded with `none`.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> cells;
    /// The caller's name of each point, for the text of a fault; empty when the names are 0, 1, 2 ...
    std::vector<Index> names = {};
    /// Called now and then by the auditing thread; an exception that it throws ends the audit. May be empty.
    std::function<void()> between = {};
    /// How many faults to list, beside counting all.
    std::size_t most_faults = 0;
};

/// What is wrong with a triangulation.
enum class Fault : std::uint8_t {
    unknown_vertex,   ///< a cell names a vertex that is not there; nothing further is examined
    flat_cell,        ///< a cell that is not positively oriented
    overlap,          ///< two cells on one side of a facet
    unused_vertex,    ///< a vertex in no cell
    duplicate_point,  ///< two vertices at one position
    not_delaunay,     ///< the sphere of a cell holds the opposite vertex of its neighbour strictly inside
    hull_not_convex,  ///< the cells do not fill the convex hull
    hull_broken,      ///< the border of the cells is not one closed surface that winds once
    not_flat,         ///< cells of a lower dimension, and a vertex that is not in their hyperplane
};
[[nodiscard]] constexpr std::string_view name_of(Fault f) {
    constexpr std::array<std::string_view, 9> names{"unknown_vertex",  "flat_cell",       "overlap",
                                                    "unused_vertex",   "duplicate_point", "not_delaunay",
                                                    "hull_not_convex", "hull_broken",     "not_flat"};
    return names[static_cast<std::size_t>(f)];
}

/// One fault. Vertices have the caller's names.
struct Audit_fault {
    Fault kind = Fault::unknown_vertex;
    /// Those that the text names; after the facet of an `overlap` the opposite vertices of both cells. Then `none`.
    std::array<Index, 5> vertices{none, none, none, none, none};
    /// The cells concerned, by number, where they are known (annulus/audit.h); otherwise -1.
    std::array<std::int64_t, 2> cells{-1, -1};
    std::string text;
};

/// The verdict of an audit, and the first fault found.
struct Audit_result {
    std::uint64_t inverted_cells = 0;      ///< finite cells not positively oriented
    std::uint64_t violated_facets = 0;     ///< facets whose sphere holds the opposite vertex strictly inside
    std::uint64_t concave_ridges = 0;      ///< places where the boundary is not convex
    std::uint64_t topological_faults = 0;  ///< facet shared by more than two cells, open boundary, missing vertex ...
    std::uint64_t degenerate_facets = 0;   ///< cospherical bi-cells: no fault, the triangulation is not unique there
    std::string first_fault;               ///< as text; empty when there is none
    std::vector<Audit_fault> faults;       ///< at most as many as the input allows, in no particular order

    /// The cells are a Delaunay triangulation of the points.
    [[nodiscard]] bool delaunay() const {
        return inverted_cells + violated_facets + concave_ridges + topological_faults == 0;
    }
};

/// Exact verdict: every cell is positive, every facet is locally Delaunay, the boundary is one closed convex surface
/// that winds once, every vertex is used, and there are no duplicate points. Integer arithmetic throughout; shares no
/// code with the certificates that it audits, nor with their predicates. O(n) big-integer determinants, a few hundred
/// nanoseconds each. Precondition: finite coordinates. docs/theory.md 1 explains why these conditions suffice, and the
/// turning number. The first fault names vertices by `input.names`, or by their index, counted from `first`.
[[nodiscard]] Audit_result audit(const Audit_input<2>& input, Index first = 0);

/// The same in 3D. Whether the boundary is one convex surface that winds once is decided from the middle of a cell:
/// every boundary triangle has its inner side towards it, a ray from it leaves through one of them, and every ridge is
/// convex. Coplanar triangles are tested in their plane. Also checks Euler's relation, which follows.
[[nodiscard]] Audit_result audit(const Audit_input<3>& input, Index first = 0);

/// An exact verdict on a triangulation made by any program: whether the cells are a Delaunay triangulation of the
/// points. It is given as arrays, such as `points` and `simplices` of scipy.spatial.Delaunay: d + 1 indices into
/// `points` for each cell, in any order, so the orientation of a cell does not matter. If all points are in a plane or
/// on a line, cells may be simplices of that dimension, 1 or 2, padded with `none`. A single point, and no point, is a
/// Delaunay triangulation without cells; any cell is a fault then.
///
/// What is examined: every index names a point; no cell is flat; no two cells are on one side of a facet; every facet
/// is locally Delaunay; the cells fill the convex hull, once; every point is a vertex; no two points coincide.
/// Cospherical points are no fault. Together these decide the question (docs/theory.md 1), in integer arithmetic, with
/// code that the triangulations of this library do not use.
///
/// The result counts all faults and lists `most_faults` of them at most, sorted by kind. Each names points by their
/// index and, for an unknown vertex, a flat cell, an overlap and a facet that is not Delaunay, also the cells by
/// theirs. `first_fault` is the text of the first one. In Audit_result::inverted_cells flat cells are counted.
///
/// Throws Error(not_finite), naming the point, and Error(too_large). O(n log n), a few microseconds for each cell;
/// longer where coordinates of very different magnitudes make long integers.
[[nodiscard]] Audit_result audit(std::span<const Coordinates<2>> points, std::span<const std::array<Index, 3>> cells,
                                 std::size_t most_faults = 100);
[[nodiscard]] Audit_result audit(std::span<const Coordinates<3>> points, std::span<const std::array<Index, 4>> cells,
                                 std::size_t most_faults = 100);

/// The same of an input whose cells have any orientation; with names and calls between (audit.h). It is modified:
/// corners are swapped.
[[nodiscard]] Audit_result audit_unoriented(Audit_input<2>& input);
[[nodiscard]] Audit_result audit_unoriented(Audit_input<3>& input);

/// The input of an audit of a periodic triangulation, nothing derived. Coordinates are taken as they are, and offsets
/// in the box's vectors, in integers: nothing is rounded.
template <int d>
struct Periodic_audit_input {
    std::vector<Coordinates<d>> points;  ///< NaN: none has this index
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
/// Preconditions: coordinates are finite, or of a point all are NaN; offsets below 2^29. Throws wrong_size where the
/// arrays of the cells differ in length.
[[nodiscard]] Audit_result audit(const Periodic_audit_input<2>& input);
[[nodiscard]] Audit_result audit(const Periodic_audit_input<3>& input);

}  // namespace annulus::inline v1
