// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/measure/voronoi_derivatives.h>
#include <annulus/measure/voronoi_facets.h>
#include <annulus/measure/voronoi_input.h>

namespace annulus::inline v1 {

namespace {

bool is_bounded(std::span<const Vertex_location> where, Index v) {
    return where[static_cast<std::size_t>(v)] == Vertex_location::inside;
}

}  // namespace

template <int d>
std::vector<Coordinates<d>> voronoi_gradient(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                             std::span<const double> weights) {
    require_weights(weights.size(), points.size());
    Voronoi_facets<d> facets(points, cells);
    return gradient_of_volumes<d>(facets, points.size(), [&](Index v) {
        return is_bounded(facets.input().where, v) ? weights[static_cast<std::size_t>(v)] : 0.0;
    });
}

template <int d>
Voronoi_jacobian<d> voronoi_jacobian(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells) {
    Voronoi_facets<d> facets(points, cells);
    return jacobian_of_volumes<d>(facets, points.size(), [&](Index v) { return is_bounded(facets.input().where, v); });
}

template std::vector<Coordinates<2>> voronoi_gradient<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                         std::span<const double>);
template std::vector<Coordinates<3>> voronoi_gradient<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                         std::span<const double>);
template Voronoi_jacobian<2> voronoi_jacobian<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&);
template Voronoi_jacobian<3> voronoi_jacobian<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&);

}  // namespace annulus::inline v1
