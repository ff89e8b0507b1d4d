// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace annulus {

/// Position of a point in R^d, in the caller's unit of length: plain doubles, no invariant.
template <int d>
using Coordinates = std::array<double, static_cast<std::size_t>(d)>;

/// Index of a vertex in input order, of a cell, or of a facet. 32 bits: at most 2^29 - 1 cells.
using Index = std::int32_t;

/// The vertex at infinity, and "no such thing".
inline constexpr Index infinite = -1;
inline constexpr Index none = -1;

}  // namespace annulus
