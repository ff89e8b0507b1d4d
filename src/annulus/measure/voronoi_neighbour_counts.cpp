// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <annulus/mesh/at.h>
#include <annulus/voronoi.h>

#include <algorithm>
#include <string>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// For points in a plane or on a line, where cells have no neighbours by which to count.
template <int d>
void count_edges(const Mesh_cells<d>& cells, std::vector<Index>& count) {
    std::vector<std::pair<Index, Index>> edges;
    for (const auto& cell : cells.vertices)
        for (std::size_t i = 0; i <= d; ++i)
            for (std::size_t k = 0; k < i; ++k)
                if (cell[i] != none && cell[k] != none)
                    edges.emplace_back(std::min(cell[i], cell[k]), std::max(cell[i], cell[k]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const auto& [a, b] : edges) {
        ++count[at(a)];
        ++count[at(b)];
    }
}

}  // namespace

template <int d>
std::vector<Index> voronoi_neighbour_counts(std::size_t n, const Mesh_cells<d>& cells) {
    if (cells.neighbours.size() != cells.vertices.size())
        throw Error(Error_code::wrong_size, "there are neighbours of " + std::to_string(cells.neighbours.size()) +
                                                " cells for " + std::to_string(cells.vertices.size()) + " cells");
    std::vector<Index> count(n, 0);  // of cells at a vertex and of facets of the hull, first
    std::vector<char> hull(n, 0);
    bool flat = false;
    for (const auto& cell : cells.vertices)
        for (const Index v : cell) {
            if (v == none) flat = true;
            else if (v < 0 || at(v) >= n)
                throw Error(Error_code::unknown_vertex,
                            "a cell names vertex " + std::to_string(v) + " of " + std::to_string(n), {v});
        }
    if (flat) {
        count_edges<d>(cells, count);
        return count;
    }
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i) {
            ++count[at(cells.vertices[c][i])];
            if (cells.neighbours[c][i] != cells.outside) continue;
            for (std::size_t k = 0; k <= d; ++k) {
                if (k == i) continue;
                ++count[at(cells.vertices[c][k])];
                hull[at(cells.vertices[c][k])] = 1;
            }
        }
    for (std::size_t v = 0; v < n; ++v) {
        if constexpr (d == 2) count[v] -= hull[v];  // two edges of the hull make it c + 1
        else if (count[v] > 0) count[v] = count[v] / 2 + 2 - hull[v];
    }
    return count;
}

template std::vector<Index> voronoi_neighbour_counts<2>(std::size_t, const Mesh_cells<2>&);
template std::vector<Index> voronoi_neighbour_counts<3>(std::size_t, const Mesh_cells<3>&);

}  // namespace annulus::inline v1
