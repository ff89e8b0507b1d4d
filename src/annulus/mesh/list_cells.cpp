// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/list_cells.h>

#include <annulus/mesh/certificates.h>
#include <annulus/mesh/corner_table.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

template <int d>
Mesh_cells<d> mesh_cells(const Corner_table<d>& t) {
    Mesh_cells<d> out;
    By_cell<Index> number(t.cell_bound().offset(), out.outside);
    for (const Cell_index c : t.finite_cells()) {
        number[c] = static_cast<Index>(out.vertices.size());
        out.vertices.push_back(cell_vertices(t, c));
    }
    out.neighbours.reserve(out.vertices.size());
    for (const Cell_index c : t.finite_cells()) {
        auto& around = out.neighbours.emplace_back();
        for (int i = 0; i <= d; ++i) around[static_cast<std::size_t>(i)] = number[t.cell_of(t.twin(t.corner(c, i)))];
    }
    return out;
}

template <int d>
Mesh_cells<d> mesh_cells(std::span<const Index> corners, std::size_t bound) {
    constexpr auto k = static_cast<std::size_t>(d + 1);
    Mesh_cells<d> out;
    out.vertices.resize(corners.size() / k);
    out.neighbours.resize(out.vertices.size());
    for (std::size_t c = 0; c < out.vertices.size(); ++c) {
        std::copy_n(&corners[c * k], k, out.vertices[c].begin());
        out.neighbours[c].fill(out.outside);
    }
    if (!corners.empty() && out.vertices[0][d] == none) return out;
    // Facets grouped by their least vertex; the few of one vertex are sorted by the others.
    using Facet = std::pair<std::array<Index, static_cast<std::size_t>(d)>, std::size_t>;  // and the opposite corner
    std::vector<Facet> facets;
    facets.reserve(corners.size());
    for (std::size_t c = 0; c < out.vertices.size(); ++c)
        for (std::size_t i = 0; i < k; ++i) {
            Facet& f = facets.emplace_back();
            f.second = c * k + i;
            for (std::size_t j = 0, n = 0; j < k; ++j)
                if (j != i) f.first[n++] = out.vertices[c][j];
            std::sort(f.first.begin(), f.first.end());
        }
    std::vector<std::size_t> first(bound + 1, 0);
    for (const Facet& f : facets) ++first[static_cast<std::size_t>(f.first[0]) + 1];
    for (std::size_t v = 0; v < bound; ++v) first[v + 1] += first[v];
    std::vector<Facet> by_vertex(facets.size());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    for (const Facet& f : facets) by_vertex[next[static_cast<std::size_t>(f.first[0])]++] = f;
    for (std::size_t v = 0; v < bound; ++v) {
        const auto begin = by_vertex.begin() + static_cast<std::ptrdiff_t>(first[v]);
        const auto end = by_vertex.begin() + static_cast<std::ptrdiff_t>(first[v + 1]);
        std::sort(begin, end);
        for (auto f = begin; f != end; ++f) {
            const auto other = f + 1;
            if (other == end || other->first != f->first) continue;
            out.neighbours[f->second / k][f->second % k] = static_cast<Index>(other->second / k);
            out.neighbours[other->second / k][other->second % k] = static_cast<Index>(f->second / k);
            f = other;
        }
    }
    return out;
}

template Mesh_cells<2> mesh_cells<2>(const Corner_table<2>&);
template Mesh_cells<3> mesh_cells<3>(const Corner_table<3>&);
template Mesh_cells<2> mesh_cells<2>(std::span<const Index>, std::size_t);
template Mesh_cells<3> mesh_cells<3>(std::span<const Index>, std::size_t);

}  // namespace annulus::inline v1
