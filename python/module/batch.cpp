// SPDX-License-Identifier: GPL-3.0-or-later
// Batches: several triangulations that move, or are read, in one call, with several threads and one release of the GIL.
#include <module/errors.h>
#include <module/mesh_locked.h>
#include <module/parts.h>
#include <module/report.h>

#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::python {

namespace {

/// Rows of an array of shape (entries, n, ..), one block for each entry.
struct Blocks {
    Blocks(const py::object& object, const char* name, std::size_t entries, py::ssize_t ndim, py::ssize_t width)
        : numbers(numbers_of(object, name)) {
        if (numbers.ndim() != ndim || static_cast<std::size_t>(numbers.shape(0)) != entries ||
            (ndim == 3 && numbers.shape(2) != width))
            throw Error(Error_code::wrong_size, std::string(name) + " must have shape (" + std::to_string(entries) +
                                                    (ndim == 3 ? ", n, " + std::to_string(width) + ")" : ", n)") +
                                                    ", not " + shape_of(numbers));
        n = static_cast<std::size_t>(numbers.shape(1));
    }
    template <int d>
    [[nodiscard]] std::span<const Coordinates<d>> points(std::size_t entry) const {
        return {reinterpret_cast<const Coordinates<d>*>(numbers.data()) + entry * n, n};
    }
    [[nodiscard]] std::span<const double> values(std::size_t entry) const { return {numbers.data() + entry * n, n}; }

    Numbers numbers;
    std::size_t n = 0;
};

template <int d>
std::vector<Mesh<d>*> meshes_of(const py::tuple& entries) {
    std::vector<Mesh<d>*> meshes;
    for (const py::handle entry : entries) meshes.push_back(entry.cast<Mesh<d>*>());
    return meshes;
}

/// Raises annulus.BatchError for the entries that have thrown an Error. What is of no entry in particular, such as
/// bad_alloc, is thrown as it is.
void raise_thrown(const std::vector<std::exception_ptr>& thrown) {
    py::dict errors;
    for (std::size_t b = 0; b < thrown.size(); ++b) {
        if (!thrown[b]) continue;
        try {
            std::rethrow_exception(thrown[b]);
        } catch (const Error& e) {
            errors[py::int_(b)] = error_of(e);
        }
    }
    if (errors.empty()) return;
    const py::object error = call(attribute_of_errors("batch_error"), py::make_tuple(errors));
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
    throw py::error_already_set();
}

/// Calls work(without_gil, b) for each entry b, all of them whatever some throw. Which thread has which entry does not
/// matter: entries share nothing.
template <class Work>
void for_each_entry(std::size_t entries, int threads, const Work& work) {
    std::vector<std::exception_ptr> thrown(entries);
    {
        const Without_gil without_gil;
        for_each_run(entries, 1, threads, [&](std::size_t first, std::size_t last) {
            for (std::size_t b = first; b < last; ++b) try {
                    work(without_gil, b);
                } catch (...) {
                    thrown[b] = std::current_exception();
                }
        });
    }
    raise_thrown(thrown);
}

/// Throws unless an entry has as many points as a batch needs: it may have been changed by itself.
template <int d>
void require_points(const Moving_mesh<d>& mesh, std::size_t n) {
    if (mesh.index_bound() != n)
        throw Error(Error_code::wrong_size,
                    "there are " + std::to_string(mesh.index_bound()) + " points, not " + std::to_string(n));
}

template <int d>
py::tuple batch_build(const py::object& points, const Options& options, int threads) {
    const Numbers numbers = numbers_of(points, "points");
    const auto entries = static_cast<std::size_t>(numbers.ndim() == 3 ? numbers.shape(0) : 0);
    const Blocks x(numbers, "points", entries, 3, d);
    std::vector<std::unique_ptr<Mesh<d>>> meshes(entries);
    for_each_entry(entries, threads, [&](const Without_gil& without_gil, std::size_t b) {
        meshes[b] = std::make_unique<Mesh<d>>(without_gil, x.points<d>(b), options);
    });
    py::tuple out(entries);
    for (std::size_t b = 0; b < entries; ++b) out[b] = py::cast(std::move(meshes[b]));
    return out;
}

template <int d>
py::tuple batch_move(const py::tuple& entries, const py::object& points, int threads) {
    const auto meshes = meshes_of<d>(entries);
    const Blocks x(points, "points", meshes.size(), 3, d);
    std::vector<Move_result> reports(meshes.size());
    for_each_entry(meshes.size(), threads, [&](const Without_gil& without_gil, std::size_t b) {
        reports[b] = meshes[b]->move(without_gil, x.points<d>(b));
    });
    py::tuple out(meshes.size());
    for (std::size_t b = 0; b < meshes.size(); ++b)
        out[b] = py::cast(Report(std::move(reports[b]), d, meshes[b]->options().report_changes));
    return out;
}

/// What read(mesh, entry) returns for each entry, n values of type T, one entry after another.
template <class T, int d, class Read>
std::vector<T> stacked(const py::tuple& entries, std::size_t n, int threads, const Read& read) {
    const auto meshes = meshes_of<d>(entries);
    std::vector<T> out(meshes.size() * n);
    for_each_entry(meshes.size(), threads, [&](const Without_gil& without_gil, std::size_t b) {
        const auto values = meshes[b]->read(without_gil, [&](const Moving_mesh<d>& mesh) {
            require_points(mesh, n);
            return read(mesh, b);
        });
        std::copy(values.begin(), values.end(), out.begin() + static_cast<std::ptrdiff_t>(b * n));
    });
    return out;
}

template <int d>
py::array batch_points(const py::tuple& entries, std::size_t n, int threads) {
    return give_rows(stacked<Coordinates<d>, d>(entries, n, threads, [](const Moving_mesh<d>& mesh, std::size_t) {
        return std::vector<Coordinates<d>>(mesh.points().begin(), mesh.points().end());
    }));
}

template <int d>
py::array batch_volumes(const py::tuple& entries, std::size_t n, int threads) {
    return give(stacked<double, d>(entries, n, threads,
                                   [](const Moving_mesh<d>& mesh, std::size_t) { return mesh.voronoi_volumes(); }));
}

template <int d>
py::array batch_gradient(const py::tuple& entries, std::size_t n, int threads, const py::object& weights) {
    const Blocks g(weights, "g", entries.size(), 2, 0);
    if (g.n != n)
        throw Error(Error_code::wrong_size, "g must have shape (" + std::to_string(entries.size()) + ", " +
                                                std::to_string(n) + "), not " + shape_of(g.numbers));
    return give_rows(stacked<Coordinates<d>, d>(entries, n, threads, [&](const Moving_mesh<d>& mesh, std::size_t b) {
        return mesh.voronoi_gradient(g.values(b));
    }));
}

}  // namespace

// The first argument is the dimension: entries are a tuple, and there may be none.
void add_batch(py::module_& m) {
    m.def("batch_build", [](int d, const py::object& points, const Options& options, int threads) {
        return d == 2 ? batch_build<2>(points, options, threads) : batch_build<3>(points, options, threads);
    });
    m.def("batch_move", [](int d, const py::tuple& entries, const py::object& points, int threads) {
        return d == 2 ? batch_move<2>(entries, points, threads) : batch_move<3>(entries, points, threads);
    });
    m.def("batch_points", [](int d, const py::tuple& entries, std::size_t n, int threads) {
        return d == 2 ? batch_points<2>(entries, n, threads) : batch_points<3>(entries, n, threads);
    });
    m.def("batch_volumes", [](int d, const py::tuple& entries, std::size_t n, int threads) {
        return d == 2 ? batch_volumes<2>(entries, n, threads) : batch_volumes<3>(entries, n, threads);
    });
    m.def("batch_gradient", [](int d, const py::tuple& entries, std::size_t n, int threads, const py::object& g) {
        return d == 2 ? batch_gradient<2>(entries, n, threads, g) : batch_gradient<3>(entries, n, threads, g);
    });
}

}  // namespace annulus::python
