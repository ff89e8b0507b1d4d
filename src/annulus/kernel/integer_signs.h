// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <optional>
#include <span>

namespace annulus::inline v1 {

// The exact stage of the kernel: signs of determinants of integers of a fixed width, without heap memory. Points on
// the unit sphere, lattices and the like are decided here. Coordinates have up to 60 bits on their finest common grid,
// or else up to 124, in integers of twice the words; points that span more bits are left to GMP.

/// A point, and a power of two that makes its coordinates integers (0: no normal double does).
template <int d>
struct Scaled_point {
    const Coordinates<d>* x;
    double scale;
};

/// The least such power. O(1).
template <int d>
[[nodiscard]] double grid_scale(const Coordinates<d>& x);

/// Orientation of d + 1 points. Empty: too many bits.
template <int d>
[[nodiscard]] std::optional<int> integer_orientation(
    const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 1)>& p);

/// Whether the sphere of a positive cell, the first d + 1 points, holds the last one; where it passes through it,
/// decided by the perturbation that is used everywhere (perturbed_sign, docs/theory.md 6.7). Empty: too many bits.
template <int d>
[[nodiscard]] std::optional<bool> integer_sphere_holds(
    const std::array<Scaled_point<d>, static_cast<std::size_t>(d + 2)>& p);

extern template double grid_scale<2>(const Coordinates<2>&);
extern template double grid_scale<3>(const Coordinates<3>&);
extern template std::optional<int> integer_orientation<2>(const std::array<Scaled_point<2>, 3>&);
extern template std::optional<int> integer_orientation<3>(const std::array<Scaled_point<3>, 4>&);
extern template std::optional<bool> integer_sphere_holds<2>(const std::array<Scaled_point<2>, 4>&);
extern template std::optional<bool> integer_sphere_holds<3>(const std::array<Scaled_point<3>, 5>&);

}  // namespace annulus::inline v1
