// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/surface_stars.h>

#include <algorithm>

namespace annulus::inline v1 {

Surface_stars::Surface_stars(std::span<const std::array<Index, 3>> facets, std::size_t n)
    : begin_(n + 2, 0), link_(3 * facets.size()) {
    for (const auto& f : facets)
        for (const Index v : f) ++begin_[static_cast<std::size_t>(v) + 2];
    for (std::size_t v = 2; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    for (const auto& f : facets)
        for (std::size_t k = 0; k < 3; ++k)
            link_[begin_[static_cast<std::size_t>(f[k]) + 1]++] = {f[(k + 1) % 3], f[(k + 2) % 3]};
}

std::span<const std::array<Index, 2>> Surface_stars::around(Index v) const {
    const std::size_t first = begin_[static_cast<std::size_t>(v)];
    return {link_.data() + first, begin_[static_cast<std::size_t>(v) + 1] - first};
}

bool Surface_stars::disc(Index v) const {
    const auto link = around(v);
    if (link.empty()) return false;
    // Exactly one edge continues from the end of each edge, and walking around visits all of them.
    Index at = link[0][0];
    for (std::size_t walked = 1; walked <= link.size(); ++walked) {
        const Index from = at;
        const auto leaves = [from](const std::array<Index, 2>& e) { return e[0] == from; };
        if (std::count_if(link.begin(), link.end(), leaves) != 1) return false;
        at = (*std::find_if(link.begin(), link.end(), leaves))[1];
        if (at == link[0][0]) return walked == link.size();
    }
    return false;
}

}  // namespace annulus::inline v1
