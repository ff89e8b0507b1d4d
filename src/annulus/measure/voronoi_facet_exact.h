// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/types.h>

#include <span>

namespace annulus::inline v1 {

/// A facet in the unit 2^exponent.
template <int d>
struct Facet_measure {
    long double measure = 0;    ///< of a range in which none underflows
    Coordinates<d> centroid{};  ///< relative to vertex i
    int exponent = 0;
};

/// Whether t is on the circumscribed circle or sphere of a cell, exactly. Some microseconds. Throws Error(bad_input)
/// for a cell that is flat.
template <int d>
[[nodiscard]] bool is_on_circumsphere(const Corners<d>& cell, const Coordinates<d>& t);

/// Whether the corners of a tetrahedron are in one plane, exactly.
[[nodiscard]] bool are_coplanar(const Corners<3>& x);

/// The facet of neighbours i and j that `ring`, the cells around their edge in order, bounds, from exact circumcentres:
/// measure with a relative error below 2^-45, centroid within 2^-45 times the largest distance from vertex i to a
/// corner. Circumcentres are rounded to q binary places, what follows is exact, and q grows until the bound of the
/// rounding is small enough. Preconditions: the facet is bounded and has an interior. Some 20 microseconds.
template <int d>
[[nodiscard]] Facet_measure<d> exact_facet(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, Index i,
                                           Index j, std::span<const Index> ring);

extern template bool is_on_circumsphere<2>(const Corners<2>&, const Coordinates<2>&);
extern template bool is_on_circumsphere<3>(const Corners<3>&, const Coordinates<3>&);
extern template Facet_measure<2> exact_facet<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&, Index, Index,
                                                std::span<const Index>);
extern template Facet_measure<3> exact_facet<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&, Index, Index,
                                                std::span<const Index>);

}  // namespace annulus::inline v1
