// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/builder.h>
#include <annulus/mesh/certificates.h>

#include <common/table_cells.h>

#include <support/catch.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace annulus::testing {

using oracle::glued;

/// The result of `builder` for the points x, which are in general position: for each corner of each cell its vertex,
/// and the corner beyond the facet opposite to it; for each vertex, and infinity, a corner.
template <int d>
std::vector<Index> built_numbers(Builder<d>& builder, std::span<const Coordinates<d>> x, int threads) {
    std::vector<Index> all(x.size());
    std::iota(all.begin(), all.end(), Index{0});
    REQUIRE(builder.build(x, all, threads));
    Corner_table<d> table;
    builder.copy_to(table, x.size(), threads);
    REQUIRE(glued(table));
    std::vector<Index> numbers;
    for (const Cell_index c : table.cells())
        for (int i = 0; i <= d; ++i) {
            numbers.push_back(table.vertex(table.corner(c, i)));
            numbers.push_back(table.twin(table.corner(c, i)).value());
        }
    for (Index v = 0; v < table.vertex_bound(); ++v) numbers.push_back(table.corner_of(v).value());
    numbers.push_back(table.corner_of_infinity().value());
    return numbers;
}

}  // namespace annulus::testing
