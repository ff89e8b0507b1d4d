// SPDX-License-Identifier: GPL-3.0-or-later
// Predicates of annulus/predicates.h over arrays, and the audit of any triangulation.
#include <module/arrays.h>
#include <module/audit_tuple.h>
#include <module/errors.h>
#include <module/finalizing.h>
#include <module/parts.h>

#include <annulus/audit.h>
#include <annulus/predicates.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace annulus::python {

namespace {

/// A predicate of k points for an array of shape (.., k, d).
template <int d, int k>
py::array signs_of(const py::object& object,
                   void (*predicate)(std::span<const std::array<Coordinates<d>, k>>, std::span<Certified_sign>)) {
    using Row = std::array<Coordinates<d>, k>;
    static_assert(sizeof(Row) == k * d * sizeof(double));
    const Numbers x = numbers_of(object, "points");
    if (x.ndim() < 2 || x.shape(x.ndim() - 1) != d || x.shape(x.ndim() - 2) != k)
        throw Error(Error_code::wrong_size, "points must have shape (.., " + std::to_string(k) + ", " +
                                                std::to_string(d) + "), not " + shape_of(x));
    std::vector<py::ssize_t> shape(x.shape(), x.shape() + x.ndim() - 2);
    std::vector<Certified_sign> out(static_cast<std::size_t>(x.size()) / (k * d));
    {
        const Without_gil without_gil;
        predicate({reinterpret_cast<const Row*>(x.data()), out.size()}, out);
    }
    return give(std::move(out), std::move(shape));
}

/// Cells as rows of d + 1 numbers; shorter rows, of flat points, are padded.
template <int d>
std::vector<std::array<Index, static_cast<std::size_t>(d) + 1>> cells_of(
    const py::array_t<std::int64_t, c_array>& rows) {
    const py::ssize_t corners = rows.shape(1);
    std::vector<std::array<Index, static_cast<std::size_t>(d) + 1>> cells(static_cast<std::size_t>(rows.shape(0)));
    const auto at = rows.unchecked<2>();
    for (py::ssize_t c = 0; c < rows.shape(0); ++c) {
        auto& cell = cells[static_cast<std::size_t>(c)];
        cell.fill(none);
        for (py::ssize_t i = 0; i < corners; ++i) {
            const std::int64_t v = at(c, i);
            if (v < -1 || v > std::numeric_limits<Index>::max())
                throw Error(Error_code::unknown_vertex,
                            "simplices: simplex " + std::to_string(c) + " names point " + std::to_string(v));
            cell[static_cast<std::size_t>(i)] = static_cast<Index>(v);
        }
    }
    return cells;
}

template <int d>
py::tuple audit_of(const Numbers& numbers, const py::array_t<std::int64_t, c_array>& rows, std::size_t most) {
    if (rows.ndim() != 2 || rows.shape(1) < 1 || rows.shape(1) > d + 1)
        throw Error(Error_code::wrong_size,
                    "simplices must have shape (m, " + std::to_string(d + 1) + "), not " + shape_of(rows));
    const Points_in<d> points(numbers, "points");
    Audit_input<d> input;
    input.points.assign(points.span().begin(), points.span().end());
    input.cells = cells_of<d>(rows);
    input.most_faults = most;
    input.between = [calls = 0U]() mutable {
        if (++calls % 16 == 0) look_for_signals();
    };
    Audit_result result;
    {
        const Without_gil without_gil;
        result = audit_unoriented(input);
    }
    return audit_tuple(result);
}

}  // namespace

py::tuple audit_tuple(const Audit_result& a) {
    py::list faults;
    for (const Audit_fault& f : a.faults) {
        py::list vertices, cells;
        for (const Index v : f.vertices)
            if (v != none) vertices.append(v);
        for (const std::int64_t c : f.cells)
            if (c >= 0) cells.append(c);
        faults.append(py::make_tuple(std::string(name_of(f.kind)), py::tuple(vertices), py::tuple(cells), f.text));
    }
    return py::make_tuple(a.delaunay(), a.inverted_cells, a.violated_facets, a.concave_ridges, a.topological_faults,
                          a.degenerate_facets, a.first_fault, faults);
}

void add_predicates(py::module_& m) {
    PYBIND11_NUMPY_DTYPE(Certified_sign, sign, tolerance, width_lower, width_upper, theta, stage);
    m.def("orient_2d", [](const py::object& points) { return signs_of<2, 3>(points, &orient_2d); });
    m.def("orient_3d", [](const py::object& points) { return signs_of<3, 4>(points, &orient_3d); });
    m.def("in_circle", [](const py::object& points) { return signs_of<2, 4>(points, &in_circle); });
    m.def("in_sphere", [](const py::object& points) { return signs_of<3, 5>(points, &in_sphere); });
    m.def("audit", [](const py::object& points, const py::object& simplices, std::size_t most) {
        const Numbers numbers = numbers_of(points, "points");
        const auto rows = whole_numbers_of(simplices, "simplices");
        const bool space = numbers.ndim() == 2 && numbers.shape(1) == 3;
        return space ? audit_of<3>(numbers, rows, most) : audit_of<2>(numbers, rows, most);
    });
}

}  // namespace annulus::python
