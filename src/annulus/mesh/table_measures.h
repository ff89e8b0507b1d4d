// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>
#include <annulus/types.h>

#include <span>

// Measures of the certificates of a table at positions x, where it is Delaunay.
namespace annulus::inline v1 {

/// Least tolerance of the certificates of v, a certified lower bound. O(degree).
template <int d>
[[nodiscard]] double star_tolerance(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v);
/// Least theta of the finite bi-cells that contain v; pi/2 when there is none. O(degree).
template <int d>
[[nodiscard]] double star_theta(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v);
/// Whether every certificate of v holds. O(degree).
template <int d>
[[nodiscard]] bool star_holds(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v);
/// Widths, tolerances and theta of everything. O(n).
template <int d>
[[nodiscard]] Measures measure(const Corner_table<d>& t, std::span<const Coordinates<d>> x);

}  // namespace annulus::inline v1
