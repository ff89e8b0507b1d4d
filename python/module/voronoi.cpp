// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi diagrams of a mesh, gradients of volumes, neighbours, nearest vertices.
#include <module/derivatives.h>
#include <module/diagram.h>
#include <module/mesh_locked.h>
#include <module/parts.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/measure/nearest_vertex.h>
#include <annulus/measure/voronoi_polytopes.h>
#include <annulus/voronoi.h>

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::python {

namespace {

/// From an array of shape (2, d), a box, or None; and an array of shape (m, d + 1), half-spaces A x + b <= 0, or None.
template <int d>
std::optional<Voronoi_clip<d>> clip_of(const py::object& box, const py::object& half_spaces) {
    if (box.is_none() && half_spaces.is_none()) return std::nullopt;
    Voronoi_clip<d> clip;
    if (!half_spaces.is_none()) {
        const Numbers rows = numbers_of(half_spaces, "clip");
        if (rows.ndim() != 2 || rows.shape(1) != d + 1)
            throw Error(Error_code::wrong_size, "clip must have shape (m, d + 1), not " + shape_of(rows));
        for (py::ssize_t r = 0; r < rows.shape(0); ++r) {
            auto& [normal, offset] = clip.half_spaces.emplace_back();
            for (int k = 0; k < d; ++k) normal[static_cast<std::size_t>(k)] = rows.at(r, k);
            offset = -rows.at(r, d);
        }
    }
    if (box.is_none()) {
        const std::vector<Half_space<d>> given = std::move(clip.half_spaces);
        return voronoi_clip<d>(given);
    }
    const Points_in<d> corners(box, "clip");
    if (corners.span().size() != 2)
        throw Error(Error_code::wrong_size, "clip must have two rows, the lower and the upper corner of a box");
    clip.lower = corners.span()[0];
    clip.upper = corners.span()[1];
    return clip;
}

template <int d>
Voronoi_diagram<d> diagram_of(const Moving_mesh<d>& mesh, const std::optional<Voronoi_clip<d>>& clip) {
    return clip ? voronoi(mesh, *clip) : voronoi(mesh);
}

/// NaN at free indices.
template <int d>
std::vector<Coordinates<d>> points_of(const Moving_mesh<d>& mesh) {
    std::vector<Coordinates<d>> points(mesh.points().begin(), mesh.points().end());
    for (std::size_t v = 0; v < points.size(); ++v)
        if (!mesh.is_vertex(static_cast<Index>(v))) points[v].fill(std::numeric_limits<double>::quiet_NaN());
    return points;
}

template <int d>
py::dict voronoi_of(const Mesh<d>& mesh, const py::object& box, const py::object& half_spaces) {
    const auto clip = clip_of<d>(box, half_spaces);
    auto [points, v] =
        mesh.read([&](const Moving_mesh<d>& m) { return std::pair(points_of<d>(m), diagram_of<d>(m, clip)); });
    return diagram_dict<d>(std::move(points), std::move(v));
}

template <int d>
py::tuple polytopes_of(const Mesh<d>& mesh, const py::object& box, const py::object& half_spaces) {
    const auto clip = clip_of<d>(box, half_spaces);
    if (!clip) throw Error(Error_code::usage, "clip must be given: without it, cells are unbounded");
    Voronoi_polytopes<d> p = mesh.read(
        [&](const Moving_mesh<d>& m) { return voronoi_polytopes<d>(m.points(), *m.vertex_neighbors(), *clip); });
    return py::make_tuple(give_rows(std::move(p.corner)), give(std::move(p.side_begin)), give(std::move(p.neighbour)),
                          give(std::move(p.corner_begin)), give(std::move(p.side_corner)));
}

template <int d>
py::array nearest_vertex(const Mesh<d>& mesh, const py::object& object) {
    const Positions_in<d> queries(object);
    return give(mesh.read([&](const Moving_mesh<d>& of) {
        const auto points = queries.span();
        for (std::size_t k = 0; k < points.size(); ++k)
            require_in_domain(points[k], "point", static_cast<std::int64_t>(k));
        if (of.number_of_vertices() == 0) throw Error(Error_code::too_few, "there is no vertex to be the nearest");
        Index first = 0;
        while (!of.is_vertex(first)) ++first;
        std::vector<Index> found = of.find_cells(points);
        const auto& cells = of.cell_lists()->cells.vertices;
        for (Index& f : found)
            if (f >= 0) f = cells[at(f)][0];
        nearest_vertices<d>(of.points(), *of.vertex_neighbors(), first, points, found);
        return found;
    }),
                queries.shape());
}

template <int d>
void add(py::module_& m) {
    m.def("nearest_vertex", &nearest_vertex<d>);
    m.def("voronoi", &voronoi_of<d>);
    m.def("voronoi_polytopes", &polytopes_of<d>);
    m.def("clipped_volumes", [](const Mesh<d>& mesh, const py::object& box, const py::object& half_spaces) {
        const auto clip = clip_of<d>(box, half_spaces);
        return give(mesh.read([&](const Moving_mesh<d>& of) { return diagram_of<d>(of, clip).volume; }));
    });
    m.def("voronoi_gradient", [](const Mesh<d>& mesh, const py::object& weights) {
        const Numbers g = weights_of(weights);
        const std::span<const double> span(g.data(), static_cast<std::size_t>(g.size()));
        return give_rows(mesh.read([&](const Moving_mesh<d>& of) { return of.voronoi_gradient(span); }));
    });
    m.def("voronoi_jacobian", [](const Mesh<d>& mesh) {
        return jacobian_tuple<d>(mesh.read(
            [](const Moving_mesh<d>& of) { return voronoi_jacobian<d>(of.points(), of.cell_lists()->cells); }));
    });
}

}  // namespace

void add_voronoi(py::module_& m) {
    m.def("clip_numbers", [](const py::object& object) { return numbers_of(object, "clip"); });
    add<2>(m);
    add<3>(m);
}

}  // namespace annulus::python
