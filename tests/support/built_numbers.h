// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/builder.h>

#include <support/catch.h>

#include <numeric>
#include <vector>

namespace annulus::testing {

/// What `builder` builds of the points x, which are in general position: for each corner of each cell its vertex, and
/// the corner beyond the facet opposite to it.
template <int d>
std::vector<Index> built_numbers(Builder<d>& builder, const std::vector<Coordinates<d>>& x, int threads) {
    std::vector<Index> all(x.size());
    std::iota(all.begin(), all.end(), Index{0});
    REQUIRE(builder.build(x, all, threads));
    Cell_table<d> table;
    builder.copy_to(table, x.size(), threads);
    std::vector<Index> numbers;
    for (const Cell_index c : table.cells())
        for (int i = 0; i <= d; ++i) {
            numbers.push_back(table.vertex(table.corner(c, i)));
            numbers.push_back(table.twin(table.corner(c, i)).value());
        }
    return numbers;
}

}  // namespace annulus::testing
