// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/flat_cells.h>
#include <annulus/internal/index.h>

#include <array>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The flat cells of these vertices at x: some of the indices of x, in any order. Precondition: no two of them are at
/// one position. O(n log n).
template <int d>
[[nodiscard]] Flat_cells flat_cells(std::span<const Coordinates<d>> x, std::vector<Index> vertices);

/// Throws Error(duplicate_point), naming two vertices at one position. O(n log n).
template <int d>
void require_distinct(std::span<const Coordinates<d>> x, std::vector<Index> vertices);

/// Whether p is outside the affine hull of affinely independent points, d of them at most. O(1).
template <int d>
[[nodiscard]] bool spans_more(std::span<const Coordinates<d>* const> independent, const Coordinates<d>& p);

#define ANNULUS_FLAT(d)                                                                            \
    extern template Flat_cells flat_cells<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    extern template void require_distinct<d>(std::span<const Coordinates<d>>, std::vector<Index>); \
    extern template bool spans_more<d>(std::span<const Coordinates<d>* const>, const Coordinates<d>&);
ANNULUS_FLAT(2)
ANNULUS_FLAT(3)
#undef ANNULUS_FLAT

}  // namespace annulus::inline v1
