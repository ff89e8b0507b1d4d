// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/json.h>

#include <string>

namespace annulus::python {

namespace py = pybind11;

py::object object_of(const nlohmann::ordered_json& json) {
    if (json.is_object()) {
        py::dict out;
        for (const auto& [key, value] : json.items()) out[py::str(key)] = object_of(value);
        return out;
    }
    if (json.is_array()) {
        py::list out;
        for (const auto& value : json) out.append(object_of(value));
        return out;
    }
    if (json.is_string()) return py::str(json.get<std::string>());
    if (json.is_boolean()) return py::bool_(json.get<bool>());
    if (json.is_number_unsigned()) return py::int_(json.get<std::uint64_t>());
    if (json.is_number_integer()) return py::int_(json.get<std::int64_t>());
    if (json.is_number_float()) return py::float_(json.get<double>());
    return py::none();
}

}  // namespace annulus::python
