// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/exact.h>
#include <annulus/space/places.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

namespace annulus::inline v1 {

/// A 2D vector over any number type.
template <class T>
struct Vector_2 {
    T x;
    T y;
};

/// A 3D vector over any number type.
template <class T>
struct Vector_3 {
    T x;
    T y;
    T z;
};

namespace detail {

template <class T>
[[nodiscard]] constexpr Vector_2<T> as_vector(std::array<T, 2> v) {
    return {std::move(v[0]), std::move(v[1])};
}
template <class T>
[[nodiscard]] constexpr Vector_3<T> as_vector(std::array<T, 3> v) {
    return {std::move(v[0]), std::move(v[1]), std::move(v[2])};
}

/// a - b, rounded.
[[nodiscard]] inline Vector_2<double> difference(const Coordinates<2>& a, const Coordinates<2>& b) {
    return as_vector(Euclidean<2>::difference(a, b));
}
[[nodiscard]] inline Vector_3<double> difference(const Coordinates<3>& a, const Coordinates<3>& b) {
    return as_vector(Euclidean<3>::difference(a, b));
}

/// Point i of a certificate minus point j, by `minus`.
template <std::size_t d, std::size_t k, class Minus = std::minus<>>
[[nodiscard]] auto difference(const std::array<const std::array<double, d>*, k>& x, std::size_t i, std::size_t j,
                              Minus minus = {}) {
    return as_vector(annulus::difference(x, i, j, minus));
}

/// The same, exactly: points of a certificate in R^d, given by all their coordinates.
template <int d>
[[nodiscard]] auto difference(const Scaled_integers& z, std::size_t i, std::size_t j) {
    return as_vector(Euclidean<d>::difference(&z.integer[d * i], &z.integer[d * j], Exact_minus()));
}

/// Functions (i, j) -> point i minus point j: of a certificate's points, by `minus`; and exact.
template <std::size_t d, std::size_t k, class Minus>
[[nodiscard]] auto vectors(const std::array<const std::array<double, d>*, k>& x, const Minus& minus) {
    return [&x, &minus](std::size_t i, std::size_t j) { return difference(x, i, j, minus); };
}
template <int d>
[[nodiscard]] auto vectors(const Scaled_integers& z) {
    return [&z](std::size_t i, std::size_t j) { return difference<d>(z, i, j); };
}

}  // namespace detail

}  // namespace annulus::inline v1
