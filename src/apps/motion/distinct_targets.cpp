// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/distinct_targets.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Whether two targets are equal, which is very rare. O(n) expected, by hashing.
bool any_equal(std::span<const Coordinates<3>> target) {
    std::size_t size = 16;
    while (size < 2 * target.size()) size *= 2;
    std::vector<Index> table(size, none);
    for (std::size_t v = 0; v < target.size(); ++v) {
        std::uint64_t key = 0;
        // -0 is 0.
        for (const double x : target[v]) key = (key ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;
        std::size_t h = static_cast<std::size_t>(key >> 20) & (size - 1);
        for (; table[h] != none; h = (h + 1) & (size - 1))
            if (target[at(table[h])] == target[v]) return true;
        table[h] = static_cast<Index>(v);
    }
    return false;
}

}  // namespace

void rest_where_equal(std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target, std::size_t& kept) {
    if (!any_equal(target)) return;
    std::vector<Index> order(target.size());
    for (std::size_t v = 0; v < order.size(); ++v) order[v] = static_cast<Index>(v);
    for (bool again = true; again;) {
        again = false;
        std::sort(order.begin(), order.end(), [&](Index a, Index b) { return target[at(a)] < target[at(b)]; });
        for (std::size_t i = 0; i < order.size();) {
            std::size_t next = i + 1;
            while (next < order.size() && target[at(order[next])] == target[at(order[i])]) ++next;
            for (std::size_t k = i; next - i > 1 && k < next; ++k) {
                const std::size_t v = at(order[k]);
                if (target[v] == position[v]) continue;
                again = true;
                ++kept;
                target[v] = position[v];
            }
            i = next;
        }
    }
}

}  // namespace annulus::inline v1
