// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/periodic_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace annulus::testing {

/// The cells of a periodic mesh as a set: each up to a translation, in an order of their own.
template <int d>
auto cells_of(const Periodic_mesh<d>& mesh) {
    using Corner = std::pair<Index, Shift<d>>;
    const auto cells = mesh.cells();
    std::vector<std::array<Corner, static_cast<std::size_t>(d + 1)>> all(cells.vertices.size());
    for (std::size_t c = 0; c < all.size(); ++c) {
        auto& cell = all[c];
        for (std::size_t i = 0; i <= d; ++i) cell[i] = {cells.vertices[c][i], cells.offsets[c][i]};
        std::sort(cell.begin(), cell.end());
        const Shift<d> first = cell[0].second;
        for (auto& [v, o] : cell)
            for (std::size_t k = 0; k < d; ++k) o[k] -= first[k];
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace annulus::testing
