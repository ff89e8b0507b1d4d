// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/json.h>
#include <module/parts.h>

#include <apps/report/counterexample_json.h>

namespace annulus::python {

void add_counterexample(py::module_& m) {
    m.def("counterexample",
          [](double delta) { return object_of(counterexample_json(counterexample(delta), "annulus.counterexample")); });
}

}  // namespace annulus::python
