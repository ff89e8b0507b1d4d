// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

namespace annulus::python {

/// The same in Python's own types; numbers that JSON cannot hold stay what they are.
[[nodiscard]] pybind11::object object_of(const nlohmann::ordered_json& json);

}  // namespace annulus::python
