// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/cells.h>

#include <algorithm>
#include <utility>

namespace annulus::python {

template <int d>
Cells<d>::Cells(const Moving_mesh<d>& mesh)
    : dimension(mesh.dimension()), simplices(mesh.cells()), simplex_of(mesh.index_bound(), -1) {
    if (dimension != d) {
        // Rows padded with -2, which would name a vertex in Python.
        for (const auto& s : simplices.vertices) flat.insert(flat.end(), s.begin(), s.begin() + (dimension + 1));
        simplices = {};
        return;
    }
    for (std::size_t c = simplices.vertices.size(); c-- > 0;)
        for (const Index v : simplices.vertices[c]) simplex_of[at(v)] = static_cast<Index>(c);
}

template <int d>
std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull_of(const Cells<d>& cells) {
    std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull;
    for (std::size_t c = 0; c < cells.simplices.vertices.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            if (cells.simplices.neighbours[c][i] != Mesh_cells<d>::outside) continue;
            const auto& v = cells.simplices.vertices[c];
            auto& facet = hull.emplace_back();
            std::size_t k = 0;
            for (std::size_t j = 0; j <= d; ++j)
                if (j != i) facet[k++] = v[j];
            // Leaving out the corner i of a positive simplex gives an orientation that alternates with i.
            if ((i + d) % 2 == (d == 2 ? 1U : 0U)) std::swap(facet[0], facet[1]);
        }
    return hull;
}

template <int d>
Adjacency adjacency_of(const Cells<d>& cells) {
    const std::size_t n = cells.simplex_of.size();
    // Calls `call` for every ordered pair of corners of every simplex.
    const auto for_each_pair = [&](auto&& call) {
        const auto pairs_of = [&](const Index* v, std::size_t corners) {
            for (std::size_t i = 0; i < corners; ++i)
                for (std::size_t j = 0; j < corners; ++j)
                    if (i != j) call(at(v[i]), v[j]);
        };
        for (const auto& s : cells.simplices.vertices) pairs_of(s.data(), d + 1);
        const auto corners = static_cast<std::size_t>(std::max(cells.dimension, 0) + 1);
        for (std::size_t k = 0; k < cells.flat.size(); k += corners) pairs_of(&cells.flat[k], corners);
    };
    std::vector<std::size_t> end(n + 1, 0);
    for_each_pair([&](std::size_t v, Index) { ++end[v + 1]; });
    for (std::size_t v = 0; v < n; ++v) end[v + 1] += end[v];
    std::vector<Index> pool(end[n]);
    std::vector<std::size_t> next(end.begin(), end.end() - 1);
    for_each_pair([&](std::size_t v, Index w) { pool[next[v]++] = w; });

    Adjacency out;
    out.begin.reserve(n + 1);
    out.begin.push_back(0);
    auto kept = pool.begin();
    for (std::size_t v = 0; v < n; ++v) {
        const auto first = pool.begin() + static_cast<std::ptrdiff_t>(end[v]),
                   last = pool.begin() + static_cast<std::ptrdiff_t>(end[v + 1]);
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

template struct Cells<2>;
template struct Cells<3>;
template std::vector<std::array<Index, 2>> hull_of(const Cells<2>&);
template std::vector<std::array<Index, 3>> hull_of(const Cells<3>&);
template Adjacency adjacency_of(const Cells<2>&);
template Adjacency adjacency_of(const Cells<3>&);

}  // namespace annulus::python
