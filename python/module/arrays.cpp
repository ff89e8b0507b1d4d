// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/arrays.h>

#include <cmath>
#include <limits>
#include <utility>

namespace annulus::python {

std::string shape_of(const py::array& a) {
    std::string text = "(";
    for (py::ssize_t k = 0; k < a.ndim(); ++k) text += (k > 0 ? ", " : "") + std::to_string(a.shape(k));
    return text + (a.ndim() == 1 ? ",)" : ")");
}

namespace {

/// numpy.asarray of it. Nearly always it is an array of NumPy's own, and there is nothing to ask.
py::array array_of(const py::object& object, const char* name) {
    if (Py_TYPE(object.ptr()) == py::detail::npy_api::get().PyArray_Type_)
        return py::reinterpret_borrow<py::array>(object);
    if (py::isinstance(object, py::module_::import("numpy.ma").attr("MaskedArray")))
        throw py::type_error(std::string(name) + ": a masked array; say what shall stand where values are masked");
    return py::module_::import("numpy").attr("asarray")(object);
}

/// Whether somebody else could write in an array while nobody here holds the GIL. What flags say of writing can change meanwhile.
bool others_may_write() {
    return PyThreadState_Next(PyInterpreterState_ThreadHead(PyInterpreterState_Get())) != nullptr;
}

/// int64 and uint64 are more than doubles have digits for.
template <class T>
void require_exact(const py::array& a, const char* name) {
    const py::array_t<T, c_array> numbers(a);
    for (py::ssize_t k = 0; k < numbers.size(); ++k) {
        const T i = numbers.data()[k];
        const auto rounded = static_cast<double>(i);
        if (rounded >= std::ldexp(1.0, std::numeric_limits<T>::digits) || static_cast<T>(rounded) != i)
            throw py::type_error(std::string(name) + " has " + std::to_string(i) +
                                 ", which is no double: round it first");
    }
}

}  // namespace

Numbers numbers_of(const py::object& object, const char* name) {
    const py::array given = array_of(object, name);
    Numbers numbers(given);
    if (!numbers.is(given) && given.itemsize() == 8) {
        const char kind = given.dtype().kind();
        if (kind == 'i') require_exact<std::int64_t>(given, name);
        if (kind == 'u') require_exact<std::uint64_t>(given, name);
    }
    // What is read more than once must not change in between, or what was proved of one position is believed of another.
    const bool fresh = numbers.owndata() && !numbers.is(given);
    if (!fresh && others_may_write()) numbers = Numbers(numbers.attr("copy")());
    return numbers;
}

namespace {

template <class T>
std::vector<Index> indices_from(const py::array& any) {
    const py::array_t<T, c_array> numbers(any);
    std::vector<Index> out;
    out.reserve(static_cast<std::size_t>(numbers.size()));
    for (py::ssize_t k = 0; k < numbers.size(); ++k) {
        const T i = numbers.data()[k];
        if (!std::in_range<Index>(i) || i < 0)
            throw Error(Error_code::unknown_vertex, "no vertex has index " + std::to_string(i));
        out.push_back(static_cast<Index>(i));
    }
    return out;
}

}  // namespace

std::vector<Index> indices_of(const py::object& object) {
    const py::array any = array_of(object, "indices");
    if (any.ndim() > 1) throw Error(Error_code::wrong_size, "indices must have shape (k,), not " + shape_of(any));
    if (any.size() == 0) return {};
    const char kind = any.dtype().kind();
    if (kind == 'b') throw py::type_error("indices must be whole numbers; for a mask write numpy.flatnonzero(mask)");
    return kind == 'u' ? indices_from<std::uint64_t>(any) : indices_from<std::int64_t>(any);
}

}  // namespace annulus::python
