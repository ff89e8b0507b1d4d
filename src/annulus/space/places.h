// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/space/euclidean.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <functional>

// The positions of the points of a certificate. Only this file looks behind these pointers.
namespace annulus::inline v1 {

/// Pointers to the positions of the points of one certificate.
template <int d, int k>
using Tuple = std::array<const Coordinates<d>*, static_cast<std::size_t>(k)>;

/// Coordinate c of point i.
template <std::size_t d, std::size_t k>
[[nodiscard]] double coordinate(const std::array<const std::array<double, d>*, k>& x, std::size_t i, std::size_t c) {
    return (*x[i])[c];
}

/// The coordinates of all points, point by point.
template <std::size_t d, std::size_t k>
[[nodiscard]] std::array<double, d * k> coordinates(const std::array<const std::array<double, d>*, k>& x) {
    std::array<double, d * k> all{};
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t c = 0; c < d; ++c) all[d * i + c] = (*x[i])[c];
    return all;
}

/// Point i minus point j.
template <std::size_t d, std::size_t k, class Minus = std::minus<>>
[[nodiscard]] auto difference(const std::array<const std::array<double, d>*, k>& x, std::size_t i, std::size_t j,
                              Minus minus = {}) {
    return Euclidean<static_cast<int>(d)>::difference(*x[i], *x[j], minus);
}

/// Whether point i comes before point j in lexicographic order.
template <std::size_t d, std::size_t k>
[[nodiscard]] bool precedes(const std::array<const std::array<double, d>*, k>& x, std::size_t i, std::size_t j) {
    return *x[i] < *x[j];
}

/// Points in 3D as they appear along an axis.
template <std::size_t k>
[[nodiscard]] std::array<Coordinates<2>, k> seen_along(std::size_t axis,
                                                       const std::array<const Coordinates<3>*, k>& x) {
    std::array<Coordinates<2>, k> y{};
    for (std::size_t i = 0; i < k; ++i) y[i] = {(*x[i])[(axis + 1) % 3], (*x[i])[(axis + 2) % 3]};
    return y;
}

}  // namespace annulus::inline v1
