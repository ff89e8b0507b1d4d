// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/distinct_facets.h>
#include <annulus/mesh/make_unique.h>

#include <algorithm>
#include <array>
#include <vector>

namespace annulus {

template <int d>
bool facets_are_distinct_around(const Cell_table<d>& t, std::span<const Cell_index> cells) {
    std::vector<Index> vertices;
    for (const Cell_index c : cells)
        for (const Index v : cell_points(t, c))
            if (v != infinite) vertices.push_back(v);
    make_unique(vertices);
    // A facet is seen once from each of its finite vertices that are asked.
    std::vector<std::pair<std::array<Index, static_cast<std::size_t>(d)>, Corner_index>> facets;
    for (const Index v : vertices)
        t.for_each_corner(v, [&](Corner_index h) {
            const Cell_index c = Cell_table<d>::cell_of(h);
            for (int i = 0; i <= d; ++i) {
                const Corner_index k = Cell_table<d>::corner(c, i);
                if (k == h) continue;
                std::array<Index, static_cast<std::size_t>(d)> x{};
                for (int j = 0, n = 0; j <= d; ++j)
                    if (j != i) x[static_cast<std::size_t>(n++)] = t.vertex(Cell_table<d>::corner(c, j));
                std::sort(x.begin(), x.end());
                facets.emplace_back(x, t.facet(k));
            }
        });
    std::sort(facets.begin(), facets.end());
    return std::adjacent_find(facets.begin(), facets.end(),
                              [](const auto& l, const auto& r) { return l.first == r.first && l.second != r.second; }) == facets.end();
}

template bool facets_are_distinct_around<2>(const Cell_table<2>&, std::span<const Cell_index>);
template bool facets_are_distinct_around<3>(const Cell_table<3>&, std::span<const Cell_index>);

}  // namespace annulus
