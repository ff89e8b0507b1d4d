// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/arrays.h>

#include <limits>

namespace annulus::python {

std::string shape_of(const py::array& a) {
    std::string text = "(";
    for (py::ssize_t k = 0; k < a.ndim(); ++k) text += (k > 0 ? ", " : "") + std::to_string(a.shape(k));
    return text + (a.ndim() == 1 ? ",)" : ")");
}

Numbers numbers_of(const py::object& object, const char* name) {
    // Nearly always it is an array of NumPy's own, and there is nothing to ask.
    const bool plain = Py_TYPE(object.ptr()) == py::detail::npy_api::get().PyArray_Type_;
    if (!plain && py::isinstance(object, py::module_::import("numpy.ma").attr("MaskedArray")))
        throw py::type_error(std::string(name) + " is a masked array: say what shall stand where values are masked");
    return Numbers(object);
}

std::vector<Index> indices_of(const py::object& object) {
    const py::array any = py::module_::import("numpy").attr("asarray")(object);
    if (any.ndim() > 1) throw Error(Error_code::wrong_size, "indices must have shape (k,), not " + shape_of(any));
    std::vector<Index> out;
    if (any.size() == 0) return out;
    if (any.dtype().kind() == 'b')
        throw py::type_error("indices must be whole numbers; for a mask write numpy.flatnonzero(mask)");
    const Whole_numbers numbers(any);
    out.reserve(static_cast<std::size_t>(numbers.size()));
    for (py::ssize_t k = 0; k < numbers.size(); ++k) {
        const std::int64_t i = numbers.data()[k];
        if (i < 0 || i > std::numeric_limits<Index>::max())
            throw Error(Error_code::unknown_vertex, "no vertex has index " + std::to_string(i));
        out.push_back(static_cast<Index>(i));
    }
    return out;
}

}  // namespace annulus::python
