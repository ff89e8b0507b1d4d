// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/errors.h>

#include <module/finalizing.h>

#include <exception>
#include <string>
#include <system_error>

namespace annulus::python {

namespace py = pybind11;

std::string_view name_of(Error_code code) {
    switch (code) {
        case Error_code::not_finite: return "not_finite";
        case Error_code::out_of_domain: return "out_of_domain";
        case Error_code::duplicate_point: return "duplicate_point";
        case Error_code::too_few: return "too_few";
        case Error_code::wrong_size: return "wrong_size";
        case Error_code::unknown_vertex: return "unknown_vertex";
        case Error_code::environment: return "environment";
        case Error_code::usage: return "usage";
        case Error_code::too_large: return "too_large";
        case Error_code::bad_input: return "bad_input";
    }
    return "";
}

py::object call(const py::object& function, const py::tuple& arguments) {
    PyObject* const result = may_wait_for_gil([&] { return PyObject_CallObject(function.ptr(), arguments.ptr()); });
    if (result == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(result);
}

py::object attribute_of_errors(const char* name) {
    PyObject* const module = may_wait_for_gil([] { return PyImport_ImportModule("annulus._error"); });
    if (module == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::object>(module).attr(name);
}

/// The class is written in Python, where it is easier to read; the package imports it before anything of this module is
/// called.
py::object error_of(const Error& e) {
    const py::object type = attribute_of_errors("Error");
    // Names of files need not be UTF-8.
    const std::string_view what = e.what();
    const auto words = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(what.data(), static_cast<Py_ssize_t>(what.size()), "backslashreplace"));
    if (!words) throw py::error_already_set();
    py::tuple vertices(e.vertices().size());
    for (std::size_t k = 0; k < e.vertices().size(); ++k) vertices[k] = py::int_(e.vertices()[k]);
    return call(type, py::make_tuple(words, py::str(std::string(name_of(e.code()))), vertices));
}

namespace {

void raise(const Error& e) {
    try {
        const py::object error = error_of(e);
        PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
    } catch (py::error_already_set& failed) {
        failed.restore();
    }
}

}  // namespace

void translate_errors() {
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (const Error& e) {
            raise(e);
        } catch (const std::system_error& e) {  // no memory for the stack of a thread
            if (e.code() != std::errc::resource_unavailable_try_again && e.code() != std::errc::not_enough_memory)
                throw;
            PyErr_NoMemory();
        }
    });
}

void look_for_signals() {
    const With_gil gil;
    if (may_wait_for_gil([] { return PyErr_CheckSignals(); }) != 0) throw py::error_already_set();
}

}  // namespace annulus::python
