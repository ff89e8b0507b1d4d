// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>

#include <pybind11/pybind11.h>

#include <string_view>

namespace annulus::python {

/// The value of `Error.code` in Python: the name in error.h.
[[nodiscard]] std::string_view name_of(Error_code code);

/// Calls a function of Python. Where Python ends meanwhile, this thread sleeps (finalizing.h).
[[nodiscard]] pybind11::object call(const pybind11::object& function, const pybind11::tuple& arguments);
/// A class or function of annulus._error.
[[nodiscard]] pybind11::object attribute_of_errors(const char* name);
/// An object annulus.Error of Python with the message, the code and the vertices of an error.
[[nodiscard]] pybind11::object error_of(const Error& e);

/// Registers the translation of annulus::Error to annulus.Error. (pybind11 translates bad_alloc to MemoryError.)
void translate_errors();

/// Runs pending signal handlers, and throws what they throw, such as KeyboardInterrupt. For long computations, between
/// two parts. Precondition: this thread does not hold the GIL.
void look_for_signals();

}  // namespace annulus::python
