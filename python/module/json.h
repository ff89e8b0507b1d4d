// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

namespace annulus::python {

/// The same content in Python's built-in types; numbers that JSON text cannot represent stay what they are.
[[nodiscard]] pybind11::object object_of(const nlohmann::ordered_json& json);

}  // namespace annulus::python
