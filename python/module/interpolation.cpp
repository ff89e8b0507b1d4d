// SPDX-License-Identifier: GPL-3.0-or-later
// Natural-neighbour interpolation.
#include <module/mesh_locked.h>
#include <module/parts.h>
#include <module/values.h>

#include <annulus/measure/laplace_weights.h>
#include <annulus/measure/sphere_side.h>

#include <array>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace annulus::python {

namespace {

/// A snapshot of a mesh.
template <int d>
struct Sites {
    std::vector<Coordinates<d>> points;
    std::shared_ptr<const Cell_lists<d>> lists;
    std::vector<Index> found;  // by query: a cell that contains it, or -1
};

/// Whether x is inside the circumscribed circle or sphere of a cell, or on it.
template <int d>
bool is_in_sphere_of(const Sites<d>& sites, Index c, const Coordinates<d>& x) {
    std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)> corners;
    for (std::size_t i = 0; i <= d; ++i) corners[i] = sites.points[at(sites.lists->cells.vertices[at(c)][i])];
    return is_in_sphere<d>(corners, x);
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
            if (n >= 0 && cells.count(n) == 0 && is_in_sphere_of<d>(sites, n, x)) {
                cells.insert(n);
                open.push_back(n);
            }
    }
    return {vertices.begin(), vertices.end()};
}

template <int d>
py::array interpolate(const Mesh<d>& mesh, const py::object& values, const py::object& positions) {
    const Positions_in<d> queries(positions);
    const Values_in f(values);
    auto result = mesh.read([&](const Moving_mesh<d>& of) {
        f.require_rows(of.index_bound());
        const Sites<d> sites{{of.points().begin(), of.points().end()}, of.cell_lists(), of.find_cells(queries.span())};
        std::vector<double> out;
        for (std::size_t q = 0; q < queries.span().size(); ++q) {
            std::vector<Index> near;
            Laplace_weights weights;
            if (sites.found[q] >= 0) {
                near = vertices_near<d>(sites, sites.found[q], queries.span()[q]);
                std::vector<Coordinates<d>> points;
                for (const Index v : near) points.push_back(sites.points[at(v)]);
                weights = laplace_weights<d>(points, queries.span()[q]);
            }
            f.append(
                out, weights.weight.size(), [&](std::size_t k) { return near[weights.point[k]]; },
                weights.weight.data());
        }
        return out;
    });
    return give(std::move(result), f.shape_at(queries.shape()));
}

}  // namespace

void add_interpolation(py::module_& m) {
    m.def("interpolate", &interpolate<2>);
    m.def("interpolate", &interpolate<3>);
}

}  // namespace annulus::python
