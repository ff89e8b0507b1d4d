// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/domain_3.h>
#include <annulus/motion/feature_curves.h>
#include <annulus/motion/sizing_3.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace annulus {

/// The vertices of a tetrahedral mesh of the domain by Delaunay refinement (CGAL's Mesh_3), about n of them, along a
/// space-filling curve; no two equal.
///
/// The size of cells is searched for until the count is within 1 % of n, in at most 12 meshes, the nearest of which
/// is taken; fine features can make that more than n. Angles of facets are asked for, and ratios of cells, where
/// sharp edges do not make that endless. Corners of `sharp` are vertices, curves of it have some, as far apart as
/// sizes and curves nearby let them, and nothing else comes near (balls that protect them). The same arguments give
/// the same points. Throws Error(usage) for n < 4, Error(too_few) when refinement finds no cell or needs more than 10
/// n + 2000 vertices, Error(bad_input) when it fails. Not thread-safe: Mesh_3 uses CGAL's default random numbers,
/// which are seeded again.
[[nodiscard]] std::vector<Coordinates<3>> initial_mesh(const Domain_3& domain, const Sizing_3& sizing, std::size_t n,
                                                       std::uint64_t seed, const Feature_curves* sharp = nullptr);

}  // namespace annulus
