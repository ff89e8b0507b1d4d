// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>

#include <array>
#include <cstddef>
#include <utility>

namespace annulus::inline v1 {

/// A facet of a cell, its corners in a standard order, with the side of it that the cell is on.
template <int d>
struct Facet_side {
    std::array<Site<d>, static_cast<std::size_t>(d)> sites;
    bool left;

    /// The facet opposite to corner `slot`, its corners in ascending order. `left` says whether these corners,
    /// followed by corner `slot`, are an even permutation of the cell.
    Facet_side(const Cell_sites<d>& x, int slot) {
        for (int k = 0, n = 0; k <= d; ++k)
            if (k != slot) sites[static_cast<std::size_t>(n++)] = x[static_cast<std::size_t>(k)];
        bool odd = (d - slot) % 2 != 0;  // the swaps that bring the corner to the end
        const auto put_in_order = [&](std::size_t i, std::size_t j) {
            if (!(sites[j] < sites[i])) return;
            std::swap(sites[i], sites[j]);
            odd = !odd;
        };
        put_in_order(0, 1);
        if constexpr (d == 3) {
            put_in_order(1, 2);
            put_in_order(0, 1);
        }
        left = !odd;
    }
};

}  // namespace annulus::inline v1
