// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace annulus {

/// A triangulation as an auditor sees it: points and finite cells, nothing derived.
template <int d>
struct Audit_input {
    std::vector<Coordinates<d>> points;
    /// d + 1 indices into `points` a cell, positively oriented. For points that span a lower dimension k < d: the
    /// k-simplices, padded with `none`.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> cells;
    /// What the caller calls each point, for the words of a fault; empty where these are 0, 1, 2 ...
    std::vector<Index> names = {};
    /// Called now and then, by the thread that audits; what it throws ends the audit. Empty where that is not needed.
    std::function<void()> between = {};
};

/// The verdict of an audit, and the first fault found.
struct Audit_result {
    std::uint64_t inverted_cells = 0;      ///< finite cells not positively oriented
    std::uint64_t violated_facets = 0;     ///< facets whose sphere holds the opposite vertex strictly inside
    std::uint64_t concave_ridges = 0;      ///< places where the boundary is not convex
    std::uint64_t topological_faults = 0;  ///< facet shared by more than two cells, open boundary, missing vertex ...
    std::uint64_t degenerate_facets = 0;   ///< cospherical bi-cells: no fault, the triangulation is not unique there
    std::string first_fault;               ///< in words; empty when there is none

    /// The cells are a Delaunay triangulation of the points.
    [[nodiscard]] bool delaunay() const {
        return inverted_cells + violated_facets + concave_ridges + topological_faults == 0;
    }
};

/// Exact verdict: every cell positive, every facet locally Delaunay, the boundary one closed convex surface that winds
/// once, every vertex used, no two at one place. Integer arithmetic throughout; shares no code with the certificates
/// it audits, nor with its predicates. O(n) big-integer determinants, a few hundred nanoseconds each.
/// Precondition: finite coordinates. Theory 1 has why these conditions suffice; docs/theory.md the turning number.
/// The first fault names vertices by `input.names`, or by their index, counted from `first`.
[[nodiscard]] Audit_result audit(const Audit_input<2>& input, Index first = 0);

/// The same in 3D. That the boundary is one convex surface that winds once is decided from the middle of a cell:
/// every boundary triangle shows it its inner side, a ray from it leaves through one of them, and every ridge is
/// convex. Triangles that are coplanar are judged in their plane. Also checks Euler's relation, which follows.
[[nodiscard]] Audit_result audit(const Audit_input<3>& input, Index first = 0);

}  // namespace annulus
