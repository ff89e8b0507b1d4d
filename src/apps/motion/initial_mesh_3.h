// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/domain_3.h>
#include <apps/motion/feature_curves.h>
#include <apps/motion/sizing_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// The vertices of a tetrahedral mesh of the domain by Delaunay refinement (CGAL's Mesh_3), about n of them, along a
/// space-filling curve; no two equal.
///
/// The size of cells is searched for until the count is within 1 % of n, in at most 12 meshes, the nearest of which is
/// taken; fine features can make that more than n. Angles of facets and radius-edge ratios of cells are criteria, too,
/// where sharp edges do not prevent termination. Corners of `sharp` become vertices; its curves get vertices as far
/// apart as the size and nearby curves allow, and protecting balls keep all other vertices away from them. The same
/// arguments give the same points. Throws Error(usage) for n < 4, Error(too_few) when refinement finds no cell or needs
/// more than 10 n + 2000 vertices, Error(bad_input) when it fails. Not thread-safe: Mesh_3 uses CGAL's default random
/// numbers, which this function seeds.
[[nodiscard]] std::vector<Coordinates<3>> initial_mesh(const Domain_3& domain, const Sizing_3& sizing, std::size_t n,
                                                       std::uint64_t seed, const Feature_curves* sharp = nullptr);

}  // namespace annulus::inline v1
