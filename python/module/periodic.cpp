// SPDX-License-Identifier: GPL-3.0-or-later
// The classes Periodic2 and Periodic3, behind annulus.PeriodicDelaunay.
#include <module/arrays.h>
#include <module/audit_tuple.h>
#include <module/derivatives.h>
#include <module/diagram.h>
#include <module/finalizing.h>
#include <module/parts.h>
#include <module/periodic_arrays.h>
#include <module/process_mutex.h>
#include <module/report.h>
#include <module/values.h>

#include <annulus/periodic_mesh.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace annulus::python {

namespace {

Periodic_strategy strategy_of(const std::string& name) {
    const auto strategy = periodic_strategy_named(name);
    if (!strategy)
        throw Error(Error_code::usage,
                    "strategy '" + name + "' is none in a periodic box; there are auto, signs and tolerances");
    return *strategy;
}

/// A Periodic_mesh that threads of Python may share: a thread that computes holds the lock and not the GIL.
template <int d>
class Periodic {
  public:
    Periodic(const py::object& points, const py::object& box, const Periodic_options& options)
        : mesh_(built(Points_in<d>(points), box_vectors_of<d>(box), options)) {}
    Periodic(const Saved_periodic_mesh<d>& saved, const Periodic_options& options) : mesh_(built(saved, options)) {}

    Report move(const py::object& points, const py::object& box) {
        const Points_in<d> x(points);
        if (box.is_none()) return report(locked([&] { return mesh_.move_all(x.span()); }));
        const auto vectors = box_vectors_of<d>(box);
        return report(locked([&] { return mesh_.move_all(x.span(), Box<d>(vectors)); }));
    }
    Report move_some(const py::object& points, const py::object& indices) {
        const Points_in<d> x(points);
        const std::vector<Index> i = indices_of(indices);
        return report(locked([&] { return mesh_.move(i, x.span()); }));
    }
    Report recompute_tolerances() {
        return report(locked([&] { return mesh_.recompute_tolerances(); }));
    }
    py::array insert(const py::object& points) {
        const Points_in<d> x(points);
        return give(locked([&] { return mesh_.insert(x.span()); }));
    }
    void remove(const py::object& indices) {
        const std::vector<Index> i = indices_of(indices);
        locked([&] { mesh_.remove(i); });
    }
    /// Vectors, places, images and free indices.
    py::tuple state() const {
        Saved_periodic_mesh<d> s = locked([&] { return mesh_.saved(); });
        return py::make_tuple(give_rows(std::vector(s.vectors.begin(), s.vectors.end())),
                              give_rows(std::move(s.places)), give_rows(std::move(s.images)),
                              give(std::move(s.free_indices)));
    }
    py::array tolerances() const {
        return give(locked([&] { return mesh_.tolerances(); }));
    }
    py::array thetas() const {
        return give(locked([&] { return mesh_.thetas(); }));
    }
    py::array points() const {
        return give_rows(locked([&] { return std::vector(mesh_.points().begin(), mesh_.points().end()); }));
    }
    py::array box() const {
        const auto vectors = locked([&] { return mesh_.box().vectors(); });
        return give_rows(std::vector(vectors.begin(), vectors.end()));
    }
    py::array simplices() const {
        return give_rows(locked([&] { return mesh_.cells().vertices; }));
    }
    py::array neighbors() const {
        return give_rows(locked([&] { return mesh_.cells().neighbours; }));
    }
    py::array simplex_offsets() const {
        return bytes_of<d>(locked([&] { return mesh_.cells().offsets; }));
    }
    py::array neighbor_offsets() const {
        return bytes_of<d>(locked([&] { return mesh_.cells().translations; }));
    }
    py::tuple neighbours() const {
        Periodic_neighbours<d> n = locked([&] { return mesh_.neighbours(); });
        return py::make_tuple(give(std::move(n.first)), give(std::move(n.second)), give(std::move(n.distance)),
                              give_rows(std::move(n.vector)), give_rows(std::move(n.shift)), give(std::move(n.area)));
    }
    /// The neighbours of each vertex, of one state: where they begin, and which they are.
    py::tuple vertex_neighbours() const {
        std::vector<Index> begin;
        Periodic_neighbours<d> n = locked([&] {
            begin.resize(mesh_.index_bound() + 1);
            return mesh_.neighbours();
        });
        for (const Index v : n.first) ++begin[static_cast<std::size_t>(v) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        return py::make_tuple(give(std::move(begin)), give(std::move(n.second)));
    }
    /// A cell of each vertex, or -1.
    py::array vertex_to_simplex() const {
        std::vector<Index> cell;
        const auto vertices = locked([&] {
            cell.assign(mesh_.index_bound(), -1);
            return mesh_.cells().vertices;
        });
        for (std::size_t c = 0; c < vertices.size(); ++c)
            for (const Index v : vertices[c]) cell[static_cast<std::size_t>(v)] = static_cast<Index>(c);
        return give(std::move(cell));
    }
    /// The cells that contain points, and their shifts.
    py::tuple find_simplex(const py::object& points) const {
        const Positions_in<d> x(points);
        return located(locked([&] { return mesh_.find_cells(x.span()); }), &Periodic_location<d>::cell, x);
    }
    /// The vertices that are nearest to points, and their shifts.
    py::tuple nearest_vertex(const py::object& points) const {
        const Positions_in<d> x(points);
        auto found = locked([&] {
            if (mesh_.number_of_vertices() == 0)
                throw Error(Error_code::too_few, "there is no vertex to be the nearest");
            return mesh_.nearest_vertices(x.span());
        });
        for (std::size_t k = 0; k < found.size(); ++k)
            if (found[k].vertex < 0)
                throw Error(Error_code::not_finite, "point " + std::to_string(k) + " is not a number",
                            {static_cast<std::int64_t>(k)});
        return located(found, &Periodic_image<d>::vertex, x);
    }
    py::array interpolate(const py::object& values, const py::object& positions) const {
        const Positions_in<d> x(positions);
        const Values_in f(values);
        auto result = locked([&] {
            f.require_rows(mesh_.index_bound());
            const Periodic_weights<d> w = mesh_.natural_neighbours(x.span());
            std::vector<double> out;
            for (std::size_t k = 0; k + 1 < w.begin.size(); ++k)
                f.append(
                    out, w.begin[k + 1] - w.begin[k], [&](std::size_t i) { return w.image[w.begin[k] + i].vertex; },
                    w.weight.data() + w.begin[k]);
            return out;
        });
        return give(std::move(result), f.shape_at(x.shape()));
    }
    /// The pairs that the last call made, or broke: first, second, shift.
    py::tuple pairs(bool made) const {
        Periodic_pairs<d> p = locked([&] { return made ? changes().made : changes().broken; });
        return py::make_tuple(give(std::move(p.first)), give(std::move(p.second)), give_rows(std::move(p.shift)));
    }
    /// The cells that the last call created, or removed: vertices, offsets.
    py::tuple changed_cells(bool created) const {
        Periodic_cell_list<d> c = locked([&] { return created ? changes().changed : changes().gone; });
        std::vector<std::int32_t> offsets;
        for (const auto& cell : c.offsets)
            for (const Shift<d>& s : cell) offsets.insert(offsets.end(), s.begin(), s.end());
        const auto m = static_cast<py::ssize_t>(c.offsets.size());
        return py::make_tuple(give_rows(std::move(c.vertices)), give(std::move(offsets), {m, d + 1, d}));
    }
    py::array neighbour_counts(double least, bool strict) const {
        return give(locked([&] { return mesh_.neighbour_counts(least, strict); }));
    }
    py::array voronoi_volumes() const {
        return give(locked([&] { return mesh_.voronoi_volumes(); }));
    }
    /// What annulus.PeriodicVoronoi is made of, points and box of the same moment included.
    py::dict voronoi() const {
        auto [points, vectors, v] = locked([&] {
            return std::tuple(std::vector(mesh_.points().begin(), mesh_.points().end()), mesh_.box().vectors(),
                              mesh_.voronoi());
        });
        py::dict out = diagram_dict<d>(std::move(points), static_cast<Voronoi_diagram<d>&&>(v));
        out["box"] = give_rows(std::vector(vectors.begin(), vectors.end()));
        out["shifts"] = give_rows(std::move(v.shift));
        out["ring_shifts"] = give_rows(std::move(v.ring_shift));
        return out;
    }
    py::array voronoi_gradient(const py::object& weights) const {
        const Numbers g = weights_of(weights);
        const std::span<const double> span(g.data(), static_cast<std::size_t>(g.size()));
        return give_rows(locked([&] { return mesh_.voronoi_gradient(span); }));
    }
    py::tuple voronoi_jacobian() const {
        return jacobian_tuple<d>(locked([&] { return mesh_.voronoi_jacobian(); }));
    }
    py::tuple audit() const {
        return audit_tuple(locked([&] { return mesh_.audit(); }));
    }
    py::array is_vertex() const {
        auto out = locked([&] {
            std::vector<std::uint8_t> there(mesh_.index_bound());
            for (std::size_t i = 0; i < there.size(); ++i) there[i] = mesh_.is_vertex(static_cast<Index>(i)) ? 1 : 0;
            return there;
        });
        return give(std::move(out)).attr("view")("bool");
    }
    py::array vertex_of_input() const {
        const auto of = mesh_.vertex_of_input();  // never changes
        return give(std::vector(of.begin(), of.end()));
    }
    std::size_t index_bound() const {
        return locked([&] { return mesh_.index_bound(); });
    }
    std::size_t vertices() const {
        return locked([&] { return mesh_.number_of_vertices(); });
    }
    std::size_t cells() const {
        return locked([&] { return mesh_.number_of_cells(); });
    }

  private:
    static Periodic_mesh<d> built(const Points_in<d>& points, const typename Box<d>::Vectors& vectors,
                                  const Periodic_options& options) {
        const Without_gil without_gil;
        return Periodic_mesh<d>(points.span(), Box<d>(vectors), options);
    }
    static Periodic_mesh<d> built(const Saved_periodic_mesh<d>& saved, const Periodic_options& options) {
        const Without_gil without_gil;
        return Periodic_mesh<d>(saved, options);
    }
    [[nodiscard]] const Periodic_changes<d>& changes() const {
        if (!mesh_.options().report_changes)
            throw Error(Error_code::usage, "the object was made without report_changes=True");
        return mesh_.changes();
    }
    /// Numbers and shifts of what was found for positions, in arrays of their shape.
    template <class Found>
    static py::tuple located(const std::vector<Found>& found, Index Found::*number, const Positions_in<d>& x) {
        std::vector<Index> numbers;
        std::vector<std::int32_t> shifts;
        for (const Found& at : found) {
            numbers.push_back(at.*number);
            shifts.insert(shifts.end(), at.shift.begin(), at.shift.end());
        }
        std::vector<py::ssize_t> rows = x.shape();
        rows.push_back(d);
        return py::make_tuple(give(std::move(numbers), x.shape()), give(std::move(shifts), std::move(rows)));
    }
    static Report report(Move_result result) { return Report(std::move(result), d, false); }
    template <class Call>
    auto locked(Call call) const {
        const Without_gil without_gil;
        const std::lock_guard hold(lock_);
        return call();
    }

    mutable Process_mutex lock_;
    Periodic_mesh<d> mesh_;
};

template <int d>
void add_periodic_mesh(py::module_& m, const char* name) {
    using P = Periodic<d>;
    py::class_<P>(m, name, not_by_new())
        .def_static("build",
                    [](const py::object& points, const py::object& box, int threads, bool report_changes,
                       const std::string& strategy, bool merge_duplicates) {
                        return std::make_unique<P>(
                            points, box,
                            Periodic_options{threads, report_changes, strategy_of(strategy), merge_duplicates});
                    })
        .def_static("build_again",
                    [](const py::object& vectors, const py::object& places, const py::object& images,
                       const py::object& free_indices, int threads, bool report_changes, const std::string& strategy) {
                        return std::make_unique<P>(saved_of<d>(vectors, places, images, free_indices),
                                                   Periodic_options{threads, report_changes, strategy_of(strategy)});
                    })
        .def("state", &P::state)
        .def("move", &P::move)
        .def("move_some", &P::move_some)
        .def("recompute_tolerances", &P::recompute_tolerances)
        .def("insert", &P::insert)
        .def("remove", &P::remove)
        .def("neighbours", &P::neighbours)
        .def("vertex_neighbours", &P::vertex_neighbours)
        .def_property_readonly("vertex_to_simplex", &P::vertex_to_simplex)
        .def("find_simplex", &P::find_simplex)
        .def("nearest_vertex", &P::nearest_vertex)
        .def("interpolate", &P::interpolate)
        .def("pairs", &P::pairs)
        .def("changed_cells", &P::changed_cells)
        .def("neighbour_counts", &P::neighbour_counts)
        .def("voronoi", &P::voronoi)
        .def("voronoi_volumes", &P::voronoi_volumes)
        .def("voronoi_gradient", &P::voronoi_gradient)
        .def("voronoi_jacobian", &P::voronoi_jacobian)
        .def("audit", &P::audit)
        .def_property_readonly("points", &P::points)
        .def_property_readonly("tolerances", &P::tolerances)
        .def_property_readonly("theta", &P::thetas)
        .def_property_readonly("box", &P::box)
        .def_property_readonly("simplices", &P::simplices)
        .def_property_readonly("simplex_offsets", &P::simplex_offsets)
        .def_property_readonly("neighbors", &P::neighbors)
        .def_property_readonly("neighbor_offsets", &P::neighbor_offsets)
        .def_property_readonly("is_vertex", &P::is_vertex)
        .def_property_readonly("index_bound", &P::index_bound)
        .def_property_readonly("vertex_of_input", &P::vertex_of_input)
        .def_property_readonly("vertices", &P::vertices)
        .def_property_readonly("cells", &P::cells);
}

}  // namespace

void add_periodic_meshes(py::module_& m) {
    add_periodic_mesh<2>(m, "Periodic2");
    add_periodic_mesh<3>(m, "Periodic3");
}

}  // namespace annulus::python
