// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/duplicate_point.h>
#include <annulus/types.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Two vertices at one position among x[i] with is_present(i); -0 and 0 are one position. O(n log n).
template <int d, class Is_present>
[[nodiscard]] std::optional<std::pair<Index, Index>> coinciding(std::span<const Coordinates<d>> x,
                                                                Is_present is_present) {
    std::vector<Index> all;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (is_present(static_cast<Index>(i))) all.push_back(static_cast<Index>(i));
    const auto place = [&](Index i) -> const Coordinates<d>& { return x[static_cast<std::size_t>(i)]; };
    std::sort(all.begin(), all.end(),
              [&](Index l, Index r) { return place(l) != place(r) ? place(l) < place(r) : l < r; });
    const auto twice =
        std::adjacent_find(all.begin(), all.end(), [&](Index l, Index r) { return place(l) == place(r); });
    if (twice == all.end()) return {};
    return std::pair(*twice, *(twice + 1));
}

/// Handles an error of a call that was to move vertices to `targets`: rethrows a duplicate point with the names of
/// both vertices, which the code that found it may not know, and anything else as it is.
template <int d, class Is_present>
[[noreturn]] void rethrow_with_vertices(const Error& e, std::span<const Coordinates<d>> targets,
                                        Is_present is_present) {
    if (e.code() != Error_code::duplicate_point) throw;
    const auto named = e.vertices();
    const auto is_true = [&](std::int64_t a, std::int64_t b) {
        return a != b && is_present(static_cast<Index>(a)) && is_present(static_cast<Index>(b)) &&
               targets[static_cast<std::size_t>(a)] == targets[static_cast<std::size_t>(b)];
    };
    if (named.size() == 2 && is_true(named[0], named[1]))
        throw duplicate_point_error("vertices", "would have", named[0], named[1]);
    if (const auto pair = coinciding<d>(targets, is_present))
        throw duplicate_point_error("vertices", "would have", pair->first, pair->second);
    throw;
}

}  // namespace annulus::inline v1
