// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// For calls that remove several vertices: throws Error(unknown_vertex) with every index that is not a vertex, or that
/// occurs twice. O(k log k).
template <class Is_vertex>
void require_removable(std::span<const Index> indices, Is_vertex is_vertex) {
    std::vector<Index> sorted(indices.begin(), indices.end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::int64_t> refused;
    for (std::size_t k = 0; k < sorted.size(); ++k)
        if ((!is_vertex(sorted[k]) || (k > 0 && sorted[k] == sorted[k - 1])) &&
            (refused.empty() || refused.back() != sorted[k]))
            refused.push_back(sorted[k]);
    if (refused.empty()) return;
    const bool twice = is_vertex(static_cast<Index>(refused.front()));
    std::string what = twice ? "vertex " + std::to_string(refused.front()) + " is to be removed twice"
                             : "no vertex has index " + std::to_string(refused.front());
    if (refused.size() > 1) what += "; " + std::to_string(refused.size() - 1) + " more are refused";
    throw Error(Error_code::unknown_vertex, what, std::move(refused));
}

}  // namespace annulus::inline v1
