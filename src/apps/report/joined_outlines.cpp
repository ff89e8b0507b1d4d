// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/joined_outlines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Outline = std::vector<Coordinates<2>>;
using Side = std::pair<std::size_t, std::size_t>;

double extent_of(const Outline& all) {
    double extent = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const auto [low, high] =
            std::minmax_element(all.begin(), all.end(), [k](const auto& a, const auto& b) { return a[k] < b[k]; });
        extent = std::max(extent, (*high)[k] - (*low)[k]);
    }
    return extent;
}

/// By corner: the number of the one that stands for all that are near it.
std::vector<std::size_t> merged(const Outline& all, double near) {
    std::vector<std::size_t> order(all.size()), stands(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a] < all[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::size_t v = order[i];
        stands[v] = v;
        for (std::size_t j = i; j-- > 0 && all[v][0] - all[order[j]][0] <= near;)
            if (std::fabs(all[v][1] - all[order[j]][1]) <= near) {
                stands[v] = stands[order[j]];
                break;
            }
    }
    return stands;
}

/// The sides that are not between two parts.
std::set<Side> outer_sides(const std::vector<Outline>& parts, const std::vector<std::size_t>& stands) {
    std::set<Side> sides;
    std::size_t first = 0;
    for (const Outline& part : parts) {
        for (std::size_t i = 0; i < part.size(); ++i) {
            const std::size_t a = stands[first + i], b = stands[first + (i + 1) % part.size()];
            if (a != b && sides.erase({b, a}) == 0) sides.insert({a, b});
        }
        first += part.size();
    }
    return sides;
}

}  // namespace

std::vector<Outline> joined_outlines(std::vector<Outline> parts) {
    if (parts.size() < 2) return parts;
    Outline all;
    for (const Outline& part : parts) all.insert(all.end(), part.begin(), part.end());
    if (all.empty()) return parts;
    std::set<Side> sides = outer_sides(parts, merged(all, 1e-9 * extent_of(all)));
    std::vector<Outline> rings;
    while (!sides.empty()) {
        const std::size_t start = sides.begin()->first;
        Outline& ring = rings.emplace_back();
        std::size_t at = start;
        do {
            const auto next = sides.lower_bound({at, 0});
            if (next == sides.end() || next->first != at) return parts;
            ring.push_back(all[at]);
            at = next->second;
            sides.erase(next);
        } while (at != start);
    }
    return rings;
}

}  // namespace annulus::inline v1
