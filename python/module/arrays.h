// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

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

// Conversion from and to NumPy arrays.
namespace annulus::python {

namespace py = pybind11;

constexpr int c_array = py::array::c_style | 0x0100;  // NPY_ARRAY_ALIGNED, which pybind11 does not name
using Numbers = py::array_t<double, c_array>;

/// The position of a vertex in an array by vertex index.
[[nodiscard]] inline std::size_t at(Index i) { return static_cast<std::size_t>(i); }

[[nodiscard]] std::string shape_of(const py::array& a);

/// The result of numpy.asarray as doubles in C order. It is the object itself if that is such an array, NumPy has
/// allocated its memory in this process, and no other thread of Python exists that could write to it; otherwise a copy.
/// Throws TypeError if the conversion could round: for long doubles, complex numbers, objects, and integers that are no
/// doubles; and for masked arrays, whose masks would be lost.
[[nodiscard]] Numbers numbers_of(const py::object& object, const char* name);

/// An array of points, (n, d), in the form that the library takes, valid as long as this object exists. It uses NumPy's
/// memory if possible.
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

/// Positions of any shape (.., d), as SciPy's find_simplex takes them.
template <int d>
class Positions_in {
  public:
    /// Throws Error(wrong_size) for another shape.
    explicit Positions_in(const py::object& object) : Positions_in(numbers_of(object, "xi")) {}
    [[nodiscard]] const Points_in<d>& points() const { return points_; }
    [[nodiscard]] std::span<const Coordinates<d>> span() const { return points_.span(); }
    /// The shape without its last axis.
    [[nodiscard]] const std::vector<py::ssize_t>& shape() const { return shape_; }

  private:
    explicit Positions_in(const Numbers& x) : points_(rows_of(x), "xi"), shape_(x.shape(), x.shape() + x.ndim() - 1) {}
    [[nodiscard]] static Numbers rows_of(const Numbers& x) {
        if (x.ndim() == 0 || x.shape(x.ndim() - 1) != d)
            throw Error(Error_code::wrong_size,
                        "xi must have shape (.., " + std::to_string(d) + "), not " + shape_of(x));
        return x.attr("reshape")(x.size() / d, d).template cast<Numbers>();
    }

    Points_in<d> points_;
    std::vector<py::ssize_t> shape_;
};

/// Vertex indices, (k,) or one number. Throws TypeError for anything but integers (also for masks), Error(wrong_size)
/// for another shape, Error(unknown_vertex) for numbers that cannot be a vertex index.
[[nodiscard]] std::vector<Index> indices_of(const py::object& object);

/// The result of numpy.asarray as whole numbers. Throws TypeError for anything but integers of at most 63 bits.
[[nodiscard]] py::array_t<std::int64_t, c_array> whole_numbers_of(const py::object& object, const char* name);

/// Rows of three indices below `points`. Throws TypeError, Error(wrong_size), Error(unknown_vertex).
[[nodiscard]] std::vector<std::array<Index, 3>> triangles_of(const py::object& object, std::size_t points);

/// A read-only array over memory that `owner` keeps alive and that must not change.
template <class T, class Owner>
[[nodiscard]] py::array view(const T* data, std::vector<py::ssize_t> shape, std::shared_ptr<const Owner> owner) {
    auto held = std::make_unique<std::shared_ptr<const Owner>>(std::move(owner));
    const py::capsule base(held.get(), [](void* p) { delete static_cast<std::shared_ptr<const Owner>*>(p); });
    (void)held.release();      // the capsule owns it
    static const T nothing{};  // NumPy would allocate for a null pointer
    py::array a(py::dtype::of<T>(), std::move(shape), data != nullptr ? data : &nothing, base);
    py::detail::array_proxy(a.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return a;
}

/// Turns a vector into an array, without a copy. The array is the only owner, so it is writable.
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
/// A read-only array of rows that `owner` keeps.
template <class T, std::size_t k, class Owner>
[[nodiscard]] py::array view_rows(const std::vector<std::array<T, k>>& rows, std::shared_ptr<const Owner> owner) {
    const T* data = rows.empty() ? nullptr : rows.front().data();
    return view<T>(data, {static_cast<py::ssize_t>(rows.size()), static_cast<py::ssize_t>(k)}, std::move(owner));
}

}  // namespace annulus::python
