// SPDX-License-Identifier: GPL-3.0-or-later
// The classes Mesh2 and Mesh3, behind annulus.MovingDelaunay.
#include <module/audit_tuple.h>
#include <module/finalizing.h>
#include <module/mesh.h>
#include <module/parts.h>
#include <module/report.h>

#include <pybind11/stl.h>

namespace annulus::python {

namespace {

template <int d>
py::array find_simplex(const Mesh<d>& mesh, const py::object& object) {
    const Positions_in<d> x(object);
    return give(mesh.find(x.points()), x.shape());
}

/// The simplices of points that span d dimensions. Read-only views of the lists; empty otherwise.
template <int d>
py::array simplices(const Mesh<d>& mesh, bool neighbours) {
    static const auto none = std::make_shared<const Cell_lists<d>>(Mesh_cells<d>{}, -1, 0);
    auto lists = mesh.cells();
    if (lists->dimension != d) lists = none;
    return view_rows(neighbours ? lists->cells.neighbours : lists->cells.vertices, lists);
}

/// Those of points that span less, without what pads their rows.
template <int d>
py::array flat_simplices(const Mesh<d>& mesh) {
    const auto lists = mesh.cells();
    const auto flat = std::make_shared<std::vector<Index>>();
    const bool is_flat = lists->dimension != d && !lists->cells.vertices.empty();
    const py::ssize_t corners = is_flat ? lists->dimension + 1 : d + 1;
    if (is_flat)
        for (const auto& v : lists->cells.vertices) flat->insert(flat->end(), v.begin(), v.begin() + corners);
    const std::shared_ptr<const std::vector<Index>> owner = flat;
    return view<Index>(owner->data(), {static_cast<py::ssize_t>(owner->size()) / corners, corners}, owner);
}

template <int d>
void add_mesh(py::module_& m, const char* name) {
    using M = Mesh<d>;
    const auto report = [](const M& mesh, Move_result r) {
        return Report(std::move(r), d, mesh.options().report_changes);
    };
    py::class_<M>(m, name, not_by_new())
        .def_static("build", [](const py::object& points,
                                const Options& o) { return std::make_unique<M>(Points_in<d>(points), o); })
        .def_static("build_again",
                    [](const py::object& points, const py::object& free_indices, const Options& o) {
                        return std::make_unique<M>(Points_in<d>(points), indices_of(free_indices), o);
                    })
        .def("move",
             [report](M& mesh, const py::object& points, const py::object& indices) {
                 if (indices.is_none()) return report(mesh, mesh.move(Points_in<d>(points)));
                 return report(mesh, mesh.move(indices_of(indices), Points_in<d>(points)));
             })
        .def("insert", [](M& mesh, const py::object& points) { return give(mesh.insert(Points_in<d>(points))); })
        .def("remove", [](M& mesh, const py::object& indices) { mesh.remove(indices_of(indices)); })
        .def("state",
             [](M& mesh) {
                 auto [points, free_indices] = mesh.state();
                 return py::make_tuple(std::move(points), give(std::move(free_indices)));
             })
        .def("summary",
             [](const M& mesh) {
                 const auto [vertices, strategy] = mesh.summary();
                 return py::make_tuple(vertices, std::string(name_of(strategy)));
             })
        .def("recompute_tolerances", [report](M& mesh) { return report(mesh, mesh.recompute_tolerances()); })
        .def("find_simplex", &find_simplex<d>)
        .def("audit", [](const M& mesh) { return audit_tuple(mesh.audit()); })
        .def("voronoi_volumes", [](M& mesh) { return give(mesh.voronoi_volumes()); })
        .def_property_readonly("points", &M::points)
        .def_property_readonly("is_vertex", &M::is_vertex)
        .def_property_readonly("vertex_of_input", [](const M& mesh) { return give(mesh.vertex_of_input()); })
        .def_property_readonly("simplices", [](const M& mesh) { return simplices<d>(mesh, false); })
        .def_property_readonly("neighbors", [](const M& mesh) { return simplices<d>(mesh, true); })
        .def_property_readonly("flat_simplices", &flat_simplices<d>)
        .def_property_readonly("vertex_to_simplex",
                               [](const M& mesh) {
                                   const auto lists = mesh.cells();
                                   const auto n = static_cast<py::ssize_t>(lists->cell_of.size());
                                   return view<Index>(lists->cell_of.data(), {n}, lists);
                               })
        .def_property_readonly("convex_hull", [](const M& mesh) { return give_rows(mesh.hull()); })
        .def_property_readonly("vertex_neighbor_vertices",
                               [](const M& mesh) {
                                   const auto a = mesh.neighbours();
                                   return py::make_tuple(
                                       view<Index>(a->begin.data(), {static_cast<py::ssize_t>(a->begin.size())}, a),
                                       view<Index>(a->index.data(), {static_cast<py::ssize_t>(a->index.size())}, a));
                               })
        .def_property_readonly("tolerances", [](const M& mesh) { return give(mesh.tolerances()); })
        .def_property_readonly("theta", [](const M& mesh) { return give(mesh.thetas()); })
        .def_property_readonly("displacements", [](const M& mesh) { return give(mesh.displacements()); })
        .def_property_readonly("vertices", &M::vertices)
        .def_property_readonly("npoints", &M::index_bound)
        .def_property_readonly("dimension", &M::dimension)
        .def_property_readonly("strategy", [](const M& mesh) { return std::string(name_of(mesh.strategy())); });
}

}  // namespace

void add_meshes(py::module_& m) {
    py::class_<Options>(m, "Options", not_by_new());
    m.def("options", &options_of);
    m.def("numbers", [](const py::object& object) { return numbers_of(object, "points"); });
    add_mesh<2>(m, "Mesh2");
    add_mesh<3>(m, "Mesh3");
}

}  // namespace annulus::python
