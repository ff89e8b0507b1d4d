// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/duplicate_point.h>
#include <annulus/types.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

/// Every i with is_present(i) and x[i] at the position of x[v], ascending. O(n).
template <int d, class Is_present>
[[nodiscard]] std::vector<std::int64_t> sharing(std::span<const Coordinates<d>> x, Index v, Is_present is_present) {
    std::vector<std::int64_t> all;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (is_present(static_cast<Index>(i)) && x[i] == x[static_cast<std::size_t>(v)])
            all.push_back(static_cast<std::int64_t>(i));
    return all;
}

/// Handles an error of a call after which the vertices would be at x: rethrows a duplicate point with the names of all
/// vertices at that position, of which the code that found it may have only two, and anything else as it is. `what`
/// and `have` as for duplicate_point_error.
template <int d, class Is_present>
[[noreturn]] void rethrow_with_vertices(const Error& e, std::span<const Coordinates<d>> x, Is_present is_present,
                                        const char* what = "vertices", const char* have = "would have") {
    if (e.code() != Error_code::duplicate_point) throw;
    const auto at = [](std::int64_t i) { return static_cast<std::size_t>(i); };
    const auto named = e.vertices();
    const bool named_rightly = named.size() == 2 && named[0] != named[1] && is_present(static_cast<Index>(named[0])) &&
                               is_present(static_cast<Index>(named[1])) && x[at(named[0])] == x[at(named[1])];
    if (named_rightly) throw duplicate_point_error(what, have, sharing<d>(x, static_cast<Index>(named[0]), is_present));
    if (const auto pair = coinciding<d>(x, is_present))
        throw duplicate_point_error(what, have, sharing<d>(x, pair->first, is_present));
    throw;
}

/// Builds a mesh of x. A duplicate point is thrown with the names of all vertices at that position.
template <int d, class Is_present, class Build>
void naming_duplicates(std::span<const Coordinates<d>> x, Is_present is_present, const char* what, Build build) {
    try {
        build();
    } catch (const Error& e) {
        rethrow_with_vertices<d>(e, x, is_present, what, "have");
    }
}

}  // namespace annulus::inline v1
