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

/// Whether a list of indices may name a vertex more than once.
enum class Repeats : bool { allowed, refused };

/// For calls that take several vertices: throws Error(unknown_vertex) with every index that is not a vertex or, where
/// repeats are refused, that occurs twice, ascending. O(k) if repeats are allowed and all are
/// vertices, else O(k log k).
template <class Is_vertex>
void require_vertices(std::span<const Index> indices, Is_vertex is_vertex, Repeats repeats = Repeats::allowed) {
    if (repeats == Repeats::allowed && std::all_of(indices.begin(), indices.end(), is_vertex)) return;
    std::vector<Index> sorted(indices.begin(), indices.end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::int64_t> refused;
    for (std::size_t k = 0; k < sorted.size(); ++k) {
        const bool again = k > 0 && sorted[k] == sorted[k - 1];
        if (is_vertex(sorted[k]) && !(again && repeats == Repeats::refused)) continue;
        if (refused.empty() || refused.back() != sorted[k]) refused.push_back(sorted[k]);
    }
    if (refused.empty()) return;
    const bool twice = is_vertex(static_cast<Index>(refused.front()));
    std::string what = twice ? "vertex " + std::to_string(refused.front()) + " is to be removed twice"
                             : "no vertex has index " + std::to_string(refused.front());
    const std::size_t more = refused.size() - 1;
    if (more > 0) what += "; " + std::to_string(more) + (more == 1 ? " more is refused" : " more are refused");
    throw Error(Error_code::unknown_vertex, what, std::move(refused));
}

}  // namespace annulus::inline v1
