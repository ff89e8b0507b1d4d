// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/laplace_weights.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/voronoi_facets.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

/// An upper bound of the largest diameter of the spheres of the cells at a vertex.
template <int d>
double diameter_upper(const Voronoi_facets<d>& facets, const Mesh_cells<d>& cells, Index v) {
    double most = 0;
    for (std::size_t c = 0; c < cells.vertices.size(); ++c) {
        if (std::find(cells.vertices[c].begin(), cells.vertices[c].end(), v) == cells.vertices[c].end()) continue;
        const Circumcentre<d>& centre = facets.centres()[c];
        double squares = 0;
        for (const double x : centre.offset) squares += x * x;
        most = std::max(most, std::sqrt(squares) + centre.error);
    }
    return std::ldexp(2 * most * (1 + 0x1p-30), facets.exponent());
}

}  // namespace

template <int d>
Laplace_weights laplace_weights(std::span<const Coordinates<d>> near, const Coordinates<d>& x, std::size_t own) {
    Laplace_weights out;
    const auto same = std::find(near.begin(), near.end(), x);
    if (same != near.end()) return {{static_cast<std::size_t>(same - near.begin())}, {1.0}, 0};
    std::vector<Coordinates<d>> points(near.begin(), near.end());
    points.push_back(x);
    const auto last = static_cast<Index>(near.size());
    Delaunay_mesh<d> mesh;
    mesh.build(points);
    const Mesh_cells<d> cells = mesh.cells(points);
    Voronoi_facets<d> facets(points, cells);
    if (!facets.input().spans || facets.input().where[near.size()] != Vertex_location::inside) return out;
    out.reach_upper = diameter_upper<d>(facets, cells, last);
    // In 3D the area of a facet may be too small for a double, or too large.
    std::vector<long double> terms;
    long double sum = 0;
    facets.for_each([&](const Voronoi_facet<d>& f) {
        if (f.j != last || f.empty || static_cast<std::size_t>(f.i) >= own) return;
        out.point.push_back(static_cast<std::size_t>(f.i));
        terms.push_back(std::ldexp(static_cast<long double>(f.measure), (d - 1) * f.exponent) / f.distance);
        sum += terms.back();
    });
    for (const long double term : terms) out.weight.push_back(static_cast<double>(term / sum));
    return out;
}

template Laplace_weights laplace_weights<2>(std::span<const Coordinates<2>>, const Coordinates<2>&, std::size_t);
template Laplace_weights laplace_weights<3>(std::span<const Coordinates<3>>, const Coordinates<3>&, std::size_t);

}  // namespace annulus::inline v1
