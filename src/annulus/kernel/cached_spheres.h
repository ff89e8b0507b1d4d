// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/growing_cells.h>

#include <cstdint>
#include <span>

namespace annulus::inline v1 {

/// Computes the cached_sphere and the bound of each of these cells, none of which is infinite. Four at a time where
/// the processor has AVX2, with the same operations, so that every bit is the same.
template <int d>
void cached_spheres(Growing_cells<d>& cells, std::span<const std::uint32_t> made);

extern template void cached_spheres(Growing_cells<2>&, std::span<const std::uint32_t>);
extern template void cached_spheres(Growing_cells<3>&, std::span<const std::uint32_t>);

}  // namespace annulus::inline v1
