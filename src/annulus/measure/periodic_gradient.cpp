// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_facets.h>
#include <annulus/measure/periodic_voronoi.h>
#include <annulus/measure/voronoi_derivatives.h>
#include <annulus/measure/voronoi_input.h>

namespace annulus::inline v1 {

template <int d>
std::vector<Coordinates<d>> periodic_voronoi_gradient(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                                      std::span<const Coordinates<d>> place,
                                                      std::span<const double> weights) {
    require_weights(weights.size(), place.size());
    Periodic_facets<d> facets(table, lattice, place);
    return gradient_of_volumes<d>(facets, place.size(), [&](Index v) { return weights[static_cast<std::size_t>(v)]; });
}

template <int d>
Voronoi_jacobian<d> periodic_voronoi_jacobian(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                              std::span<const Coordinates<d>> place) {
    Periodic_facets<d> facets(table, lattice, place);
    return jacobian_of_volumes<d>(facets, place.size(), [](Index) { return true; });
}

template std::vector<Coordinates<2>> periodic_voronoi_gradient(const Periodic_table<2>&, const Lattice<2>&,
                                                               std::span<const Coordinates<2>>,
                                                               std::span<const double>);
template std::vector<Coordinates<3>> periodic_voronoi_gradient(const Periodic_table<3>&, const Lattice<3>&,
                                                               std::span<const Coordinates<3>>,
                                                               std::span<const double>);
template Voronoi_jacobian<2> periodic_voronoi_jacobian(const Periodic_table<2>&, const Lattice<2>&,
                                                       std::span<const Coordinates<2>>);
template Voronoi_jacobian<3> periodic_voronoi_jacobian(const Periodic_table<3>&, const Lattice<3>&,
                                                       std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
