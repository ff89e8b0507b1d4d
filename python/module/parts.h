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

/// Options from their names. Throws Error(usage) for a name that there is not, with those that there are, and for no thread.
[[nodiscard]] Options options_of(const std::string& strategy, const std::string& tolerance,
                                 const std::string& second_look, int threads, bool merge_duplicates,
                                 bool report_changes, std::uint64_t seed);

}  // namespace annulus::python
