// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <apps/cli/boxed_mesh.h>
#include <apps/motion/density_2.h>
#include <apps/motion/region_2.h>
#include <apps/report/run_record.h>
#include <apps/report/svg_triangulation.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

/// A 2D triangulation as a page measures and shows it.
struct Plane_view {
    Plane_step measures;
    Picture cells;  ///< Voronoi cells, with the shades of their numbers of neighbours; of many those in the middle
};

/// Voronoi cells are cut to the domain, into several parts where it is not convex; those of which that takes something
/// are at the border. Triangles are measured where the circumcentre, in which three cells meet, is in the domain. With
/// a density the energy of the cells is measured. Neighbours are those with a facet that is not exactly empty.
/// Precondition: the triangulation is Delaunay. O(n), 4 microseconds a vertex.
[[nodiscard]] Plane_view plane_view(const Moving_mesh_2& dt, const Region_2& domain, const Density_2* density,
                                    std::string caption);
/// Without a domain. Cells are cut to the clip, as to a domain, if there is one, and those that it cuts are at the
/// border; else those that are unbounded, and for the picture all are cut to a box around the points. Nothing where
/// lengths are not between 1e-100 and 1e100, or the points are in one place.
[[nodiscard]] std::optional<Plane_view> plane_view(const Moving_mesh_2& dt, const std::optional<Clip_record>& clip,
                                                   std::string caption);
/// The cells of the points of a periodic box.
[[nodiscard]] std::optional<Plane_view> plane_view(const Boxed_mesh<2>& dt, const Density_2* density,
                                                   std::string caption);
/// A periodic box has no clip, and there is no such view in 3D.
template <class Moving>
[[nodiscard]] std::optional<Plane_view> plane_view(const Moving& dt, const std::optional<Clip_record>&,
                                                   std::string caption) {
    if constexpr (Moving::dimension_of_space == 2) return plane_view(dt, nullptr, std::move(caption));
    else return {};
}

/// The border of a domain, for the outline of pictures: a disc as a polygon of many corners; of a polygon that is not
/// convex each edge, there and back. Linear.
[[nodiscard]] std::vector<std::vector<Coordinates<2>>> border_of(const Region_2& domain);

/// Whether a run measures after iteration i: 1, 2, 3, 5, 7, 10, 20, 30, 50 .., and the last, because a measurement
/// takes as long as a few iterations.
[[nodiscard]] bool is_viewed(std::uint64_t i, std::uint64_t last);

}  // namespace annulus::inline v1::cli
