// SPDX-License-Identifier: GPL-3.0-or-later
// annulus._core: what of the Python package is compiled. The package says what things are for.
#include <module/errors.h>
#include <module/parts.h>

PYBIND11_MODULE(_core, m) {
    using namespace annulus::python;
    m.doc() = "What is compiled of the package annulus; nothing here is for users.";
    m.attr("version") = ANNULUS_VERSION;
    translate_errors();
    add_report(m);
    add_meshes(m);
    add_degeneracy(m);
    add_counterexample(m);
    add_lloyd(m);
    add_nodt(m);
}
