// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/voronoi.h>

#include <span>
#include <vector>

// What is measured on a periodic triangulation: a proved table (kernel/periodic_proof.h), the places of its vertices.
// Needs rounding to nearest.
namespace annulus::inline v1 {

/// The neighbour list. Shifts are by vectors of the box, and for the images of the points that the representatives
/// name. O(n log n) at worst, O(n) where vertices have few neighbours.
///
/// The facet of an edge is the polygon of the circumcentres of the cells around it; in 2D the segment between two. It
/// is exactly empty where at most two of them differ (docs/theory.md 8.6): where at most two of the bi-cells around the
/// edge are not cospherical. Areas of other facets are computed in doubles from circumcentres with errors below 2^-40
/// of the shortest edge of their cell, and are positive.
template <int d>
[[nodiscard]] Periodic_neighbours<d> periodic_neighbours(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                                         std::span<const Coordinates<d>> place,
                                                         std::span<const Shift<d>> image);

/// The areas or volumes of the Voronoi cells by vertex, with a relative error of voronoi_volume_error (voronoi.h) at
/// most, by the method of voronoi_volumes. All cells are bounded. NaN where
/// a place is. O(n).
template <int d>
[[nodiscard]] std::vector<double> periodic_voronoi_volumes(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                                           std::span<const Coordinates<d>> place);

/// voronoi_gradient (voronoi.h) of a periodic box that keeps its vectors, with the same errors: all images of a vertex
/// move with it. O(n). Throws wrong_size unless there is a weight for each place.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> periodic_voronoi_gradient(const Periodic_table<d>& table,
                                                                    const Lattice<d>& lattice,
                                                                    std::span<const Coordinates<d>> place,
                                                                    std::span<const double> weights);

/// voronoi_jacobian of a periodic box. A row has an entry for each neighbouring vertex, the sum over its images.
template <int d>
[[nodiscard]] Voronoi_jacobian<d> periodic_voronoi_jacobian(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                                            std::span<const Coordinates<d>> place);

extern template Periodic_neighbours<2> periodic_neighbours(const Periodic_table<2>&, const Lattice<2>&,
                                                           std::span<const Coordinates<2>>, std::span<const Shift<2>>);
extern template Periodic_neighbours<3> periodic_neighbours(const Periodic_table<3>&, const Lattice<3>&,
                                                           std::span<const Coordinates<3>>, std::span<const Shift<3>>);
extern template std::vector<double> periodic_voronoi_volumes(const Periodic_table<2>&, const Lattice<2>&,
                                                             std::span<const Coordinates<2>>);
extern template std::vector<double> periodic_voronoi_volumes(const Periodic_table<3>&, const Lattice<3>&,
                                                             std::span<const Coordinates<3>>);
extern template std::vector<Coordinates<2>> periodic_voronoi_gradient(const Periodic_table<2>&, const Lattice<2>&,
                                                                      std::span<const Coordinates<2>>,
                                                                      std::span<const double>);
extern template std::vector<Coordinates<3>> periodic_voronoi_gradient(const Periodic_table<3>&, const Lattice<3>&,
                                                                      std::span<const Coordinates<3>>,
                                                                      std::span<const double>);
extern template Voronoi_jacobian<2> periodic_voronoi_jacobian(const Periodic_table<2>&, const Lattice<2>&,
                                                              std::span<const Coordinates<2>>);
extern template Voronoi_jacobian<3> periodic_voronoi_jacobian(const Periodic_table<3>&, const Lattice<3>&,
                                                              std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
