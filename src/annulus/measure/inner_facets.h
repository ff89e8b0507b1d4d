// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>
#include <annulus/measure/voronoi_exact.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>

namespace annulus::inline v1 {

/// A facet between two finite cells. Circumcentres are relative to the first corners of their cells.
template <int d>
struct Inner_facet {
    Index cell, beyond;
    Index first, first_beyond;                               ///< the first corners of the two
    std::array<Index, static_cast<std::size_t>(d)> corners;  ///< in the order of facet_corners, seen from cell
};

/// The cells of a list, for for_each_inner_facet.
[[nodiscard]] inline auto all_cells(std::size_t cells) {
    return Index_range(Cell_index(static_cast<Index>(cells)), [](Cell_index) { return true; });
}

/// Visits facets between finite cells: cell by cell in the order of `numbers`, a range of Index or Cell_index, and in a
/// cell facet by facet. O(1) for each.
///
/// `Cells` gives access to a table or list of cells: is_finite(c); corner(c, i), a vertex; beyond(c, i), the cell
/// beyond the facet opposite to it; owns(c, n), for every such n, also where there is no cell: whether the facet is
/// visited from c, which must be true from one of its two sides only.
///
/// Half of the facets are skipped, which no branch predictor foresees. Hence they are collected without branches, and
/// visited in batches.
template <int d, class Cells, class Numbers, class Visit>
void for_each_inner_facet(const Cells& cells, const Numbers& numbers, Visit visit) {
    struct Owned {
        Index cell, beyond;
        std::size_t opposite;
    };
    constexpr std::size_t batch = 256;
    std::array<Owned, batch + d + 1> owned;
    std::size_t count = 0;
    const auto flush = [&] {
        for (std::size_t k = 0; k < count; ++k) {
            const auto& [c, n, i] = owned[k];
            if (!cells.is_finite(n)) continue;
            Inner_facet<d> f{c, n, cells.corner(c, 0), cells.corner(n, 0), {}};
            for (std::size_t j = 0; j < d; ++j) f.corners[j] = cells.corner(c, facet_corners<d>[i][j]);
            visit(f);
        }
        count = 0;
    };
    const auto collect = [&](Index c) {
        if (!cells.is_finite(c)) return;
        for (std::size_t i = 0; i <= d; ++i) {
            owned[count] = {c, cells.beyond(c, i), i};
            count += cells.owns(c, owned[count].beyond) ? 1 : 0;
        }
        if (count >= batch) flush();
    };
    for (const auto c : numbers)
        if constexpr (requires { c.value(); }) collect(c.value());
        else collect(c);
    flush();
}

}  // namespace annulus::inline v1
