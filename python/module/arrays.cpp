// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/arrays.h>

#include <module/finalizing.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace annulus::python {

std::string shape_of(const py::array& a) {
    std::string text = "(";
    for (py::ssize_t k = 0; k < a.ndim() && k < 8; ++k) text += (k > 0 ? ", " : "") + std::to_string(a.shape(k));
    return text + (a.ndim() > 8 ? ", ..)" : a.ndim() == 1 ? ",)" : ")");
}

namespace {

/// numpy.asarray of the object. In nearly all cases it is a NumPy array already and returned as it is.
py::array array_of(const py::object& object, const char* name) {
    if (Py_TYPE(object.ptr()) == py::detail::npy_api::get().PyArray_Type_)
        return py::reinterpret_borrow<py::array>(object);
    PyObject* const made = may_wait_for_gil([&]() -> PyObject* {
        PyObject* const module = PyImport_ImportModule("annulus._arguments");
        if (module == nullptr) return nullptr;
        PyObject* const array = PyObject_CallMethod(module, "array_of", "Os", object.ptr(), name);
        Py_DECREF(module);
        return array;
    });
    if (made == nullptr) throw py::error_already_set();
    return py::reinterpret_steal<py::array>(made);
}

/// The name of a dtype, such as "float128", if it is short.
std::string dtype_of(const py::array& a) {
    const auto text = py::str(py::object(a.dtype())).cast<std::string>();
    return text.size() <= 40 ? text : "a structured type";
}

/// The same numbers in C order as type T, which must be able to hold them; or the array itself.
template <class T>
py::array_t<T, c_array> converted(const py::array& a) {
    return may_wait_for_gil([&] { return py::array_t<T, c_array>(a); });
}

template <class T>
py::array_t<T, c_array> copied(const py::array_t<T, c_array>& a) {
    const py::array_t<T, c_array> copy(std::vector<py::ssize_t>(a.shape(), a.shape() + a.ndim()));
    if (a.size() > 0) std::memcpy(const_cast<T*>(copy.data()), a.data(), static_cast<std::size_t>(a.nbytes()));
    return copy;
}

/// Converts int64 or uint64, which may have more digits than a double. Copies first, so that the numbers that are
/// compared are those that are returned, even if another thread writes to the array.
template <class T>
Numbers exact(const py::array& a, const char* name) {
    auto numbers = converted<T>(a);
    if (numbers.is(a)) numbers = copied(numbers);
    const Numbers out(std::vector<py::ssize_t>(numbers.shape(), numbers.shape() + numbers.ndim()));
    auto* const to = const_cast<double*>(out.data());
    for (py::ssize_t k = 0; k < numbers.size(); ++k) {
        const T i = numbers.data()[k];
        to[k] = static_cast<double>(i);
        if (to[k] >= std::ldexp(1.0, std::numeric_limits<T>::digits) || static_cast<T>(to[k]) != i)
            throw py::type_error(std::string(name) + " has " + std::to_string(i) +
                                 ", which is no double: round it first");
    }
    return out;
}

/// Whether another thread of Python could write to an array while this thread does not hold the GIL.
bool other_threads() { return PyThreadState_Next(PyInterpreterState_ThreadHead(PyInterpreterState_Get())) != nullptr; }

/// Whether NumPy has allocated the memory of this array, or of the array that it is a view of, so that no other process
/// can write to it. This excludes memory from a file, shared memory, and memory of other packages.
bool is_private(const py::array& a) {
    py::handle owner = a;
    for (int depth = 0; depth < 32 && owner && Py_TYPE(owner.ptr()) == py::detail::npy_api::get().PyArray_Type_;
         ++depth) {
        const auto* const array = py::detail::array_proxy(owner.ptr());
        if ((array->flags & py::detail::npy_api::NPY_ARRAY_OWNDATA_) != 0) return true;
        owner = array->base;
    }
    return false;
}

}  // namespace

Numbers numbers_of(const py::object& object, const char* name) {
    const py::array given = array_of(object, name);
    const char kind = given.dtype().kind();
    if ((kind != 'f' && kind != 'i' && kind != 'u') || given.itemsize() > 8)
        throw py::type_error(std::string(name) + " must be numbers that float64 holds exactly, not an array of " +
                             dtype_of(given));
    if (given.itemsize() == 8 && kind == 'i') return exact<std::int64_t>(given, name);
    if (given.itemsize() == 8 && kind == 'u') return exact<std::uint64_t>(given, name);
    const Numbers numbers = converted<double>(given);
    // The library reads a position more than once. If it changed in between, a proof for one position would be used for
    // another.
    const bool fresh = numbers.owndata() && !numbers.is(given);
    return fresh || (!other_threads() && is_private(numbers)) ? numbers : copied(numbers);
}

namespace {

template <class T>
std::vector<Index> indices_from(const py::array& any) {
    const auto numbers = converted<T>(any);
    std::vector<Index> out;
    out.reserve(static_cast<std::size_t>(numbers.size()));
    std::vector<std::int64_t> beyond;
    for (py::ssize_t k = 0; k < numbers.size(); ++k) {
        const T i = numbers.data()[k];
        if (std::in_range<Index>(i)) out.push_back(static_cast<Index>(i));  // the mesh refuses negative ones
        else beyond.push_back(std::in_range<std::int64_t>(i) ? static_cast<std::int64_t>(i) : INT64_MAX);
    }
    if (beyond.empty()) return out;
    std::sort(beyond.begin(), beyond.end());
    beyond.erase(std::unique(beyond.begin(), beyond.end()), beyond.end());
    throw Error(Error_code::unknown_vertex, "indices: no vertex has index " + std::to_string(beyond.front()), beyond);
}

}  // namespace

std::vector<Index> indices_of(const py::object& object) {
    const py::array any = array_of(object, "indices");
    if (any.ndim() > 1) throw Error(Error_code::wrong_size, "indices must have shape (k,), not " + shape_of(any));
    if (any.size() == 0) return {};
    const char kind = any.dtype().kind();
    if (kind == 'b') throw py::type_error("indices must be whole numbers; for a mask write numpy.flatnonzero(mask)");
    if (kind == 'u') return indices_from<std::uint64_t>(any);
    if (kind == 'i') return indices_from<std::int64_t>(any);
    throw py::type_error("indices must be whole numbers, not an array of " + dtype_of(any));
}

py::array_t<std::int64_t, c_array> whole_numbers_of(const py::object& object, const char* name) {
    const py::array any = array_of(object, name);
    const char kind = any.dtype().kind();
    if ((kind != 'i' && kind != 'u') || (kind == 'u' && any.itemsize() == 8))
        throw py::type_error(std::string(name) + " must be whole numbers of at most 63 bits, not an array of " +
                             dtype_of(any));
    return converted<std::int64_t>(any);
}

std::vector<std::array<Index, 3>> triangles_of(const py::object& object, std::size_t points) {
    const auto numbers = whole_numbers_of(object, "surface: triangles");
    if (numbers.ndim() != 2 || numbers.shape(1) != 3)
        throw Error(Error_code::wrong_size, "surface: triangles must have shape (m, 3), not " + shape_of(numbers));
    std::vector<std::array<Index, 3>> out(static_cast<std::size_t>(numbers.shape(0)));
    for (py::ssize_t k = 0; k < numbers.shape(0); ++k)
        for (py::ssize_t i = 0; i < 3; ++i) {
            const std::int64_t v = numbers.data()[3 * k + i];
            if (v < 0 || static_cast<std::uint64_t>(v) >= points)
                throw Error(Error_code::unknown_vertex,
                            "surface: triangle " + std::to_string(k) + " names point " + std::to_string(v), {v});
            out[static_cast<std::size_t>(k)][static_cast<std::size_t>(i)] = static_cast<Index>(v);
        }
    return out;
}

}  // namespace annulus::python
