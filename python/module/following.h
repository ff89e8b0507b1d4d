// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>
#include <module/errors.h>
#include <module/finalizing.h>
#include <module/report.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace annulus::python {

/// What a run of a motion returns about its steps.
struct History {
    std::vector<double> mean, max;  ///< displacements, by step
    Move_result total;

    void add(double mean_displacement, double max_displacement, const Move_result& report) {
        mean.push_back(mean_displacement);
        max.push_back(max_displacement);
        total += report;
    }
};

/// Called between two steps, without the GIL: handles signals and runs the caller's callback. False if the callback
/// ends the iterations.
inline bool goes_on(const py::object& callback, const History& history) {
    look_for_signals();
    if (callback.is_none()) return true;
    const With_gil gil;
    const py::tuple arguments = py::make_tuple(history.mean.size(), history.mean.back(), history.max.back());
    const int enough = may_wait_for_gil([&] {
        PyObject* const answer = PyObject_Call(callback.ptr(), arguments.ptr(), nullptr);
        if (answer == nullptr) return -1;
        const int is_true = PyObject_IsTrue(answer);
        Py_DECREF(answer);
        return is_true;
    });
    if (enough < 0) throw py::error_already_set();
    return enough == 0;
}

inline void require_iterations(std::int64_t iterations) {
    if (iterations < 0)
        throw Error(Error_code::usage, "iterations must be 0 or more, not " + std::to_string(iterations));
}

}  // namespace annulus::python
