// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One certificate as an array of points, in the same form for all four kinds.

#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/filtered.h>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace annulus::testing {

/// d + 1 points are an orientation, d + 2 an empty circle or sphere.
template <int d, std::size_t k>
using Case = std::array<Coordinates<d>, k>;

template <int d, std::size_t k>
inline constexpr bool is_orientation = k == static_cast<std::size_t>(d) + 1;

template <int d, std::size_t k>
[[nodiscard]] constexpr std::string_view certificate_name() {
    if (is_orientation<d, k>) return d == 2 ? "orientation_2" : "orientation_3";
    return d == 2 ? "empty_circle_2" : "empty_sphere_3";
}

template <int d, std::size_t k>
[[nodiscard]] auto tuple_of(const Case<d, k>& x) {
    std::array<const Coordinates<d>*, k> t{};
    for (std::size_t i = 0; i < k; ++i) t[i] = &x[i];
    return t;
}

template <int d, std::size_t k>
[[nodiscard]] Certificate_value filtered_value(const Case<d, k>& x) {
    if constexpr (is_orientation<d, k>) return evaluate_orientation(tuple_of<d, k>(x));
    else return evaluate_empty_sphere(tuple_of<d, k>(x));
}
template <int d, std::size_t k>
[[nodiscard]] Certificate_value exact_verdict(const Case<d, k>& x) {
    if constexpr (is_orientation<d, k>) return orientation_exact(tuple_of<d, k>(x));
    else return empty_sphere_exact(tuple_of<d, k>(x));
}
template <int d, std::size_t k>
[[nodiscard]] int sign_alone(const Case<d, k>& x) {
    if constexpr (is_orientation<d, k>) return exact_orientation_sign(tuple_of<d, k>(x)).sign;
    else return exact_empty_sphere_sign(tuple_of<d, k>(x)).sign;
}

}  // namespace annulus::testing
