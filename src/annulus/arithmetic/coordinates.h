// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// Position of a point in R^d, in the caller's unit of length: plain doubles, no invariant.
template <int d>
using Coordinates = std::array<double, static_cast<std::size_t>(d)>;

/// Index of a vertex in input order. 32 bits: at most 2^29 cells. Cells and corners of a Corner_table have their own
/// types (mesh/index.h).
using Index = std::int32_t;

/// The vertex at infinity.
inline constexpr Index infinite = -1;
/// No vertex at all, not even infinity: pads arrays that have more entries than vertices.
inline constexpr Index none = -2;

}  // namespace annulus::inline v1
