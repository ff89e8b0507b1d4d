// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <optional>

namespace annulus::inline v1 {

// The exact stage where coordinates fit: signs of determinants of integers of a fixed width, without heap memory.
// Points on the unit sphere, lattices and the like are decided here. Coordinates have up to 60 bits on their finest
// common grid, or else up to 124, in integers of twice the words; where points span more bits, the answer is empty, and
// integers of any size have to decide (exact.h).

/// A point, and a power of two that makes its coordinates integers (0: no normal double does).
template <int d>
struct Scaled_point {
    const Coordinates<d>* x;
    double scale;
};

/// The least such power. O(1).
template <int d>
[[nodiscard]] double grid_scale(const Coordinates<d>& x);

/// The points of a certificate, each with that power.
template <std::size_t d, std::size_t k>
[[nodiscard]] std::array<Scaled_point<static_cast<int>(d)>, k> scaled_points(
    const std::array<const std::array<double, d>*, k>& x) {
    std::array<Scaled_point<static_cast<int>(d)>, k> p;
    for (std::size_t i = 0; i < k; ++i) {
        const std::array<double, d>& point = *x[i];
        p[i] = {&point, grid_scale<static_cast<int>(d)>(point)};
    }
    return p;
}

/// The sign of the orientation of d + 1 points.
template <int d>
[[nodiscard]] std::optional<int> integer_orientation(
    const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 1)>& p);

/// The sign of an empty sphere, with the points in the order of the predicates: {a, b, p, q}, or {a, b, c, p, q}.
/// Positive when the cell with q is, and its sphere leaves p outside; 0 where the sphere passes through p.
template <int d>
[[nodiscard]] std::optional<int> integer_empty_sphere(
    const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p);

/// The same in 3D with the signs of Bicell_terms_3::side, but for the first.
struct Bicell_signs {
    int sphere;
    std::array<int, 3> side;  ///< of ab | cpq, ca | bpq, bc | apq
};
[[nodiscard]] std::optional<Bicell_signs> integer_bicell(const std::array<Scaled_point<3>, 5>& p);

/// Whether the sphere of a positive cell, the first d + 1 points, holds the last one; where it passes through it,
/// decided by the perturbation that is used everywhere (perturbed_sign, docs/theory.md 6.7).
template <int d>
[[nodiscard]] std::optional<bool> integer_sphere_holds(
    const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p);

extern template double grid_scale<2>(const Coordinates<2>&);
extern template double grid_scale<3>(const Coordinates<3>&);
extern template std::optional<int> integer_orientation<2>(const std::array<Scaled_point<2>, 3>&);
extern template std::optional<int> integer_orientation<3>(const std::array<Scaled_point<3>, 4>&);
extern template std::optional<int> integer_empty_sphere<2>(const std::array<Scaled_point<2>, 4>&);
extern template std::optional<int> integer_empty_sphere<3>(const std::array<Scaled_point<3>, 5>&);
extern template std::optional<bool> integer_sphere_holds<2>(const std::array<Scaled_point<2>, 4>&);
extern template std::optional<bool> integer_sphere_holds<3>(const std::array<Scaled_point<3>, 5>&);

}  // namespace annulus::inline v1
