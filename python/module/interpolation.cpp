// SPDX-License-Identifier: GPL-3.0-or-later
// Natural-neighbour interpolation.
#include <module/mesh_locked.h>
#include <module/parts.h>

#include <annulus/measure/voronoi_facets.h>
#include <annulus/predicates.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace annulus::python {

namespace {

constexpr double outside = std::numeric_limits<double>::quiet_NaN();

/// A snapshot of a mesh.
template <int d>
struct Sites {
    std::vector<Coordinates<d>> points;
    std::shared_ptr<const Cell_lists<d>> lists;
    std::vector<Index> found;  // by query: a cell that contains it, or -1
};

/// Whether x is inside the circumscribed circle or sphere of a cell, or on it.
template <int d>
bool is_in_sphere(const Sites<d>& sites, Index c, const Coordinates<d>& x) {
    const auto& v = sites.lists->cells.vertices[at(c)];
    const auto p = [&](std::size_t i) -> const Coordinates<d>& { return sites.points[at(v[i])]; };
    if constexpr (d == 2) return in_circle(p(0), p(1), p(2), x).sign >= 0;
    else  // cells have a positive det(b - a, c - a, e - a), which orient_3d is
        return in_sphere(p(0), p(1), p(2), p(3), x).sign >= 0;
}

/// The vertices that x would be joined to, and perhaps others, which are on the circles or spheres of the cells that
/// would go.
template <int d>
std::vector<Index> vertices_near(const Sites<d>& sites, Index start, const Coordinates<d>& x) {
    std::set<Index> cells{start};
    std::vector<Index> open{start};
    std::set<Index> vertices;
    while (!open.empty()) {
        const Index c = open.back();
        open.pop_back();
        vertices.insert(sites.lists->cells.vertices[at(c)].begin(), sites.lists->cells.vertices[at(c)].end());
        for (const Index n : sites.lists->cells.neighbours[at(c)])
            if (n >= 0 && cells.count(n) == 0 && is_in_sphere<d>(sites, n, x)) {
                cells.insert(n);
                open.push_back(n);
            }
    }
    return {vertices.begin(), vertices.end()};
}

/// Calls use(vertex, weight) for each natural neighbour of x; false where x is not in the interior of the hull.
template <int d, class Use>
bool for_each_weight(const Sites<d>& sites, Index start, const Coordinates<d>& x, Use use) {
    if (start < 0) return false;
    const std::vector<Index> near = vertices_near<d>(sites, start, x);
    std::vector<Coordinates<d>> points;
    for (const Index v : near) {
        points.push_back(sites.points[at(v)]);
        if (points.back() == x) {
            use(v, 1.0);
            return true;
        }
    }
    points.push_back(x);
    const auto last = static_cast<Index>(near.size());
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(points)};
    Voronoi_facets<d> facets(mesh.points(), mesh.cell_lists()->cells);
    if (facets.input().where[at(last)] != Vertex_location::inside) return false;
    // In 3D the area of a facet may be too small for a double, or too large.
    std::vector<std::pair<Index, long double>> weights;
    long double sum = 0;
    facets.for_each([&](const Voronoi_facet<d>& f) {
        if (f.j != last || f.empty) return;
        weights.emplace_back(f.i, std::ldexp(static_cast<long double>(f.measure), (d - 1) * f.exponent) / f.distance);
        sum += weights.back().second;
    });
    for (const auto& [i, weight] : weights) use(near[at(i)], static_cast<double>(weight / sum));
    return true;
}

template <int d>
py::array interpolate(const Mesh<d>& mesh, const py::object& values, const py::object& positions) {
    const Numbers x = numbers_of(positions, "xi");
    if (x.ndim() == 0 || x.shape(x.ndim() - 1) != d)
        throw Error(Error_code::wrong_size, "xi must have shape (.., " + std::to_string(d) + "), not " + shape_of(x));
    const Numbers f = numbers_of(values, "values");
    if (f.ndim() == 0) throw Error(Error_code::wrong_size, "values must have shape (npoints, ..), not ()");
    std::vector<py::ssize_t> shape(x.shape(), x.shape() + x.ndim() - 1);
    shape.insert(shape.end(), f.shape() + 1, f.shape() + f.ndim());
    std::size_t width = 1;
    for (py::ssize_t k = 1; k < f.ndim(); ++k) width *= static_cast<std::size_t>(f.shape(k));
    const Points_in<d> queries(x.attr("reshape")(x.size() / d, d).template cast<Numbers>(), "xi");
    const auto rows = static_cast<std::size_t>(f.shape(0));
    const double* const from = f.data();
    auto result = mesh.read([&](const Moving_mesh<d>& of) {
        if (rows != of.index_bound())
            throw Error(Error_code::wrong_size, "values must have " + std::to_string(of.index_bound()) +
                                                    " rows, one for each point, not " + std::to_string(rows));
        const Sites<d> sites{{of.points().begin(), of.points().end()}, of.cell_lists(), of.find_cells(queries.span())};
        std::vector<double> out(queries.span().size() * width, outside);
        for (std::size_t q = 0; q < queries.span().size(); ++q) {
            std::vector<double> sum(width, 0.0);
            if (for_each_weight<d>(sites, sites.found[q], queries.span()[q], [&](Index v, double weight) {
                    for (std::size_t k = 0; k < width; ++k) sum[k] += weight * from[at(v) * width + k];
                }))
                std::copy(sum.begin(), sum.end(), out.begin() + static_cast<std::ptrdiff_t>(q * width));
        }
        return out;
    });
    return give(std::move(result), std::move(shape));
}

}  // namespace

void add_interpolation(py::module_& m) {
    m.def("interpolate", &interpolate<2>);
    m.def("interpolate", &interpolate<3>);
}

}  // namespace annulus::python
