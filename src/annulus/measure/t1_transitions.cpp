// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/t1_transitions.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Triangle = std::array<Index, 3>;  // ascending
struct Signed_triangle {
    Triangle corners;
    int sign;
};

void append(std::span<const Index> cells, int sign, std::vector<Signed_triangle>& all) {
    for (std::size_t c = 0; c < cells.size(); c += 3) {
        Triangle corners{cells[c], cells[c + 1], cells[c + 2]};
        std::sort(corners.begin(), corners.end());
        if (corners[0] >= 0) all.push_back({corners, sign});
    }
}

/// An edge of a triangle and the corner opposite to it.
struct Side {
    std::pair<Index, Index> edge;
    Index opposite;

    friend bool operator<(const Side& a, const Side& b) {
        return a.edge != b.edge ? a.edge < b.edge : a.opposite < b.opposite;
    }
};

std::vector<Side> sides_of(const std::vector<Triangle>& triangles) {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for (const auto& [a, b, c] : triangles) {
        sides.push_back({{a, b}, c});
        sides.push_back({{a, c}, b});
        sides.push_back({{b, c}, a});
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// The sides of an edge.
std::span<const Side> at(const std::vector<Side>& sides, std::pair<Index, Index> edge) {
    const auto less = [](const auto& a, const auto& b) { return a.edge < b.edge; };
    const auto [first, last] = std::equal_range(sides.begin(), sides.end(), Side{edge, 0}, less);
    return {first, last};
}

}  // namespace

T1_transitions t1_transitions(std::span<const Index> came, std::span<const Index> gone) {
    std::vector<Signed_triangle> all;
    append(came, 1, all);
    append(gone, -1, all);
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.corners < b.corners; });
    std::vector<Triangle> now, before;
    for (std::size_t i = 0; i < all.size();) {
        const Triangle corners = all[i].corners;
        int sum = 0;
        for (; i < all.size() && all[i].corners == corners; ++i) sum += all[i].sign;
        if (sum != 0) (sum > 0 ? now : before).push_back(corners);
    }
    const std::vector<Side> sides_now = sides_of(now), sides_before = sides_of(before);
    T1_transitions out;
    for (std::size_t i = 0; i + 1 < sides_before.size(); ++i) {
        const Side &one = sides_before[i], &other = sides_before[i + 1];
        if (one.edge != other.edge) continue;
        // Both triangles of an edge went: it is broken unless another has it now. The same the other way round.
        const std::pair<Index, Index> across{one.opposite, other.opposite};
        const auto there = at(sides_now, across);
        if (there.size() == 2 && there[0].opposite == one.edge.first && there[1].opposite == one.edge.second &&
            at(sides_now, one.edge).empty() && at(sides_before, across).empty())
            out.push_back({one.edge.first, one.edge.second, across.first, across.second});
    }
    return out;
}

}  // namespace annulus::inline v1
