// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/voronoi_kept.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// voronoi_gradient in 2D, up to rounding, from the circumcentres that are kept for the volumes: 0.1 microseconds per
/// vertex if the volumes have been updated to the positions x. Throws as voronoi_gradient does.
[[nodiscard]] std::vector<Coordinates<2>> edge_gradient(Kept_voronoi_volumes<2>& kept,
                                                        std::span<const Coordinates<2>> x,
                                                        std::span<const double> weights);

}  // namespace annulus::inline v1
