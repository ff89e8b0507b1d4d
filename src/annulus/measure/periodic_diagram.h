// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/periodic_state.h>
#include <annulus/voronoi.h>

namespace annulus::inline v1 {

/// The Voronoi diagram of a periodic triangulation, in the frame of the points as they were given; facets and sums are
/// those of Periodic_facets, in an order that depends on the table alone. O(n), and O(k log k) for k neighbours of a
/// vertex. Needs rounding to nearest.
template <int d>
[[nodiscard]] Periodic_voronoi_diagram<d> periodic_voronoi_diagram(const Periodic_state<d>& state);

extern template Periodic_voronoi_diagram<2> periodic_voronoi_diagram(const Periodic_state<2>&);
extern template Periodic_voronoi_diagram<3> periodic_voronoi_diagram(const Periodic_state<3>&);

}  // namespace annulus::inline v1
