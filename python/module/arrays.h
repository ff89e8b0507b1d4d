// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/arithmetic/error.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// NumPy's arrays in and out.
namespace annulus::python {

namespace py = pybind11;

constexpr int c_array = py::array::c_style | 0x0100;  // NPY_ARRAY_ALIGNED, which pybind11 does not name
using Numbers = py::array_t<double, c_array>;

/// Where a vertex is in an array.
[[nodiscard]] inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

[[nodiscard]] std::string shape_of(const py::array& a);

/// What numpy.asarray makes of it as doubles in C order: itself if it is that and its memory is NumPy's own, of this
/// process, with no other thread of Python there to write in it; else a copy. Throws TypeError where that could
/// round: of long doubles, complex numbers, objects, whole numbers that are no doubles; and for masked arrays, whose
/// masks would be lost.
[[nodiscard]] Numbers numbers_of(const py::object& object, const char* name);

/// An array of points, (n, d), as the library takes them, for as long as this lives. Its memory is NumPy's where that
/// can be.
template <int d>
class Points_in {
  public:
    /// Throws Error(wrong_size) for another shape.
    explicit Points_in(const py::object& object, const char* name = "points")
        : Points_in(numbers_of(object, name), name) {}
    Points_in(Numbers numbers, const char* name) : numbers_(std::move(numbers)) {
        if (numbers_.ndim() != 2 || numbers_.shape(1) != d)
            throw Error(Error_code::wrong_size, std::string(name) + " must have shape (n, " + std::to_string(d) +
                                                    "), not " + shape_of(numbers_));
    }
    // A Coordinates<d> is d doubles and nothing else.
    [[nodiscard]] std::span<const Coordinates<d>> span() const {
        static_assert(sizeof(Coordinates<d>) == d * sizeof(double));
        return {reinterpret_cast<const Coordinates<d>*>(numbers_.data()), static_cast<std::size_t>(numbers_.shape(0))};
    }

  private:
    Numbers numbers_;
};

/// Vertex indices, (k,) or one number. Throws TypeError for what are no whole numbers (masks are none),
/// Error(wrong_size) for another shape, Error(unknown_vertex) for those that no vertex can have.
[[nodiscard]] std::vector<Index> indices_of(const py::object& object);

/// Rows of three indices of so many points. Throws TypeError, Error(wrong_size), Error(unknown_vertex).
[[nodiscard]] std::vector<std::array<Index, 3>> triangles_of(const py::object& object, std::size_t points);

/// A read-only array over memory that `owner` keeps alive, and that nobody changes.
template <class T, class Owner>
[[nodiscard]] py::array view(const T* data, std::vector<py::ssize_t> shape, std::shared_ptr<const Owner> owner) {
    auto held = std::make_unique<std::shared_ptr<const Owner>>(std::move(owner));
    const py::capsule base(held.get(), [](void* p) { delete static_cast<std::shared_ptr<const Owner>*>(p); });
    (void)held.release();      // the capsule's
    static const T nothing{};  // NumPy would allocate for a null pointer
    py::array a(py::dtype::of<T>(), std::move(shape), data != nullptr ? data : &nothing, base);
    py::detail::array_proxy(a.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return a;
}

/// The array that a vector becomes, without a copy. Nobody else has it, so it may be written in.
template <class T>
[[nodiscard]] py::array give(std::vector<T> values, std::vector<py::ssize_t> shape) {
    auto owner = std::make_shared<const std::vector<T>>(std::move(values));
    const T* data = owner->data();
    py::array a = view<T>(data, std::move(shape), std::move(owner));
    py::detail::array_proxy(a.ptr())->flags |= py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return a;
}
template <class T>
[[nodiscard]] py::array give(std::vector<T> values) {
    const auto n = static_cast<py::ssize_t>(values.size());
    return give(std::move(values), {n});
}
/// Points, or cells: a row for each.
template <class T, std::size_t k>
[[nodiscard]] py::array give_rows(std::vector<std::array<T, k>> rows) {
    const auto n = static_cast<py::ssize_t>(rows.size());
    auto owner = std::make_shared<const std::vector<std::array<T, k>>>(std::move(rows));
    const T* data = n > 0 ? owner->front().data() : nullptr;
    py::array a = view<T>(data, {n, static_cast<py::ssize_t>(k)}, std::move(owner));
    py::detail::array_proxy(a.ptr())->flags |= py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return a;
}
/// The same for whoever keeps them: read-only.
template <class T, std::size_t k, class Owner>
[[nodiscard]] py::array view_rows(const std::vector<std::array<T, k>>& rows, std::shared_ptr<const Owner> owner) {
    const T* data = rows.empty() ? nullptr : rows.front().data();
    return view<T>(data, {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(k)}, std::move(owner));
}

}  // namespace annulus::python
