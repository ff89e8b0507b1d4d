// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <span>

namespace annulus {

/// Whether no two facets that meet the vertices of these cells have the same vertices. Flips leave what they are made in a manifold, but
/// where it was no Delaunay triangulation they can make an edge that is there already. O(k log k) for the k cells that meet them.
template <int d>
[[nodiscard]] bool facets_are_distinct_around(const Cell_table<d>& t, std::span<const Cell_index> cells);

extern template bool facets_are_distinct_around<2>(const Cell_table<2>&, std::span<const Cell_index>);
extern template bool facets_are_distinct_around<3>(const Cell_table<3>&, std::span<const Cell_index>);

}  // namespace annulus
