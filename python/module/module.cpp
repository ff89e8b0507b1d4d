// SPDX-License-Identifier: GPL-3.0-or-later
// annulus._core: the compiled part of the Python package. The package documents it.
#include <annulus/version.h>

#include <module/errors.h>
#include <module/finalizing.h>
#include <module/parts.h>

// The init function that pybind11 defines is renamed and called from the real one below: in a subinterpreter pybind11
// would wait for ever before it calls any code of this module.
namespace {
bool in_main_interpreter() { return PyInterpreterState_Get() == PyInterpreterState_Main(); }
}  // namespace

#define PyInit__core annulus_core_of_pybind11
PYBIND11_MODULE(_core, m) {
    using namespace annulus::python;
    wait_at_the_end();
    m.doc() = "What is compiled of the package annulus; nothing here is for users.";
    m.attr("version") = ANNULUS_VERSION_STRING;
    m.def("in_main_interpreter", &in_main_interpreter);
    translate_errors();
    add_report(m);
    add_meshes(m);
    add_periodic_meshes(m);
    add_degeneracy(m);
    add_predicates(m);
    add_voronoi(m);
    add_batch(m);
    add_interpolation(m);
    add_counterexample(m);
    add_lloyd(m);
    add_nodt(m);
    add_table(m);
}
#undef PyInit__core

extern "C" PYBIND11_EXPORT PyObject* PyInit__core();
extern "C" PYBIND11_EXPORT PyObject* PyInit__core() {
    if (in_main_interpreter()) return annulus_core_of_pybind11();
    PyErr_SetString(PyExc_ImportError, "annulus works in the main interpreter only, and this is a subinterpreter");
    return nullptr;
}
