// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/options.h>

#include <pybind11/pybind11.h>

#include <string>

// What the module is put together from: a file each.
namespace annulus::python {

namespace py = pybind11;

void add_report(py::module_& m);
void add_meshes(py::module_& m);
void add_degeneracy(py::module_& m);
void add_counterexample(py::module_& m);
void add_lloyd(py::module_& m);
void add_nodt(py::module_& m);

/// Of classes whose objects come from C++ alone: pybind11 would hand out one that `__new__` made as if it had been
/// initialised.
[[nodiscard]] inline py::custom_type_setup not_by_new() {
    return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
#ifdef Py_TPFLAGS_DISALLOW_INSTANTIATION
        heap_type->ht_type.tp_flags |= Py_TPFLAGS_DISALLOW_INSTANTIATION;
#else
        (void)heap_type;  // Python 3.9
#endif
    });
}

/// Options from their names. Throws Error(usage) for a name that there is not, with those that there are, and for no
/// thread.
[[nodiscard]] Options options_of(const std::string& strategy, const std::string& tolerance, int threads,
                                 bool merge_duplicates, bool report_changes, std::uint64_t seed);

}  // namespace annulus::python
