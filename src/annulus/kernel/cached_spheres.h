// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/growing_cells.h>

#include <cstdint>
#include <span>

namespace annulus {

/// The spheres of these cells, none of which is at infinity, and their bounds: cached_sphere of each. Four at a time
/// where the processor can (AVX2), with the same operations, so that not a bit depends on it.
void cached_spheres(Growing_cells<3>& cells, std::span<const std::uint32_t> made);

}  // namespace annulus
