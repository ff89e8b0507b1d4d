// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/options.h>

#include <pybind11/pybind11.h>

#include <string>

// The parts of the module, one file each.
namespace annulus::python {

namespace py = pybind11;

void add_report(py::module_& m);
void add_meshes(py::module_& m);
void add_periodic_meshes(py::module_& m);
void add_degeneracy(py::module_& m);
void add_predicates(py::module_& m);
void add_voronoi(py::module_& m);
void add_batch(py::module_& m);
void add_interpolation(py::module_& m);
void add_counterexample(py::module_& m);
void add_lloyd(py::module_& m);
void add_nodt(py::module_& m);
void add_table(py::module_& m);

/// For classes whose objects are created only in C++: pybind11 would treat an object made by `__new__` as if it had
/// been initialised.
[[nodiscard]] inline py::custom_type_setup not_by_new() {
    return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
#ifdef Py_TPFLAGS_DISALLOW_INSTANTIATION
        heap_type->ht_type.tp_flags |= Py_TPFLAGS_DISALLOW_INSTANTIATION;
#else
        (void)heap_type;  // Python 3.9
#endif
    });
}

/// Options from their names. Throws Error(usage) for an unknown name, with a list of the known ones, and if `threads`
/// is less than 1.
[[nodiscard]] Options options_of(const std::string& strategy, const std::string& tolerance, int threads,
                                 bool merge_duplicates, bool report_changes, std::uint64_t seed);

}  // namespace annulus::python
