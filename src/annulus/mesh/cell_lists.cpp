// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/cell_lists.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

template <int d>
Cell_lists<d>::Cell_lists(Mesh_cells<d> listed, int affine_dimension, std::size_t bound)
    : cells(std::move(listed)), dimension(affine_dimension), cell_of(bound, -1) {
    if (dimension != d) return;
    for (std::size_t c = cells.vertices.size(); c-- > 0;)
        for (const Index v : cells.vertices[c]) cell_of[static_cast<std::size_t>(v)] = static_cast<Index>(c);
}

template <int d>
std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull_facets(const Cell_lists<d>& lists) {
    std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull;
    if (lists.dimension != d) return hull;
    for (std::size_t c = 0; c < lists.cells.vertices.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            if (lists.cells.neighbours[c][i] != Mesh_cells<d>::outside) continue;
            const auto& v = lists.cells.vertices[c];
            auto& facet = hull.emplace_back();
            std::size_t k = 0;
            for (std::size_t j = 0; j <= d; ++j)
                if (j != i) facet[k++] = v[j];
            // Without corner i, the orientation of what remains of a positive cell alternates with i.
            if (i % 2 == 1) std::swap(facet[0], facet[1]);
        }
    return hull;
}

template <int d>
Vertex_neighbours vertex_neighbours(const Cell_lists<d>& lists) {
    const std::size_t n = lists.cell_of.size();
    const auto corners = static_cast<std::size_t>(std::max(lists.dimension, 0) + 1);
    // Calls `call` for every ordered pair of corners of every cell.
    const auto for_each_pair = [&](auto&& call) {
        for (const auto& v : lists.cells.vertices)
            for (std::size_t i = 0; i < corners; ++i)
                for (std::size_t j = 0; j < corners; ++j)
                    if (i != j) call(static_cast<std::size_t>(v[i]), v[j]);
    };
    std::vector<std::size_t> end(n + 1, 0);
    for_each_pair([&](std::size_t v, Index) { ++end[v + 1]; });
    for (std::size_t v = 0; v < n; ++v) end[v + 1] += end[v];
    std::vector<Index> pool(end[n]);
    std::vector<std::size_t> next(end.begin(), end.end() - 1);
    for_each_pair([&](std::size_t v, Index w) { pool[next[v]++] = w; });

    Vertex_neighbours out;
    out.begin.reserve(n + 1);
    out.begin.push_back(0);
    auto kept = pool.begin();
    for (std::size_t v = 0; v < n; ++v) {
        const auto first = pool.begin() + static_cast<std::ptrdiff_t>(end[v]);
        const auto last = pool.begin() + static_cast<std::ptrdiff_t>(end[v + 1]);
        std::sort(first, last);
        const auto end_of_list = std::unique(first, last);
        kept = kept == first ? end_of_list : std::copy(first, end_of_list, kept);
        out.begin.push_back(static_cast<Index>(kept - pool.begin()));
    }
    pool.erase(kept, pool.end());
    pool.shrink_to_fit();
    out.index = std::move(pool);
    return out;
}

template struct Cell_lists<2>;
template struct Cell_lists<3>;
template std::vector<std::array<Index, 2>> hull_facets(const Cell_lists<2>&);
template std::vector<std::array<Index, 3>> hull_facets(const Cell_lists<3>&);
template Vertex_neighbours vertex_neighbours(const Cell_lists<2>&);
template Vertex_neighbours vertex_neighbours(const Cell_lists<3>&);

}  // namespace annulus::inline v1
