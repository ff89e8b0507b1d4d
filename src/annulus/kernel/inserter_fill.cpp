// SPDX-License-Identifier: GPL-3.0-or-later
// Inserter: the new cells that replace a cavity.
#include <annulus/kernel/inserter.h>

#include <annulus/kernel/cached_spheres.h>

#include <span>
#include <tuple>

namespace annulus::inline v1 {

namespace {
constexpr auto others_3 = facing<3>();
}

/// To be called before the cells of the cavity are overwritten.
template <>
void Inserter<3>::read_border() {
    constexpr int d = 3;
    Cavity& cavity = cavity_;
    if (cavity.facets.size() < cavity.border_size) cavity.facets.resize(2 * cavity.border_size);
    cavity_edges_.with_numbers([&](auto number) {
        for (std::size_t f = 0; f < cavity.border_size; ++f) {
            const Half_facet h = cavity.border[f];
            const auto& cell = cells_->cells[h >> 2];
            Facet& facet = cavity.facets[f];
            for (std::size_t k = 0; k < d; ++k) facet.vertex[k] = cell.vertex[others_3[h & 3U][k]];
            facet.beyond = cell.across[h & 3U];
            for (std::size_t k = 0; k < d; ++k) facet.number[k] = number(facet.vertex[k]);
        }
    });
}

template <>
void Inserter<3>::fill(Rank v) {
    read_border();
    Cells& g = *cells_;
    const std::span<const Facet> facets(cavity_.facets.data(), cavity_.border_size);
    const Cell* const cells = cavity_.cells.data();
    cavity_edges_.with_edges(facets.size(), [&](auto edge) {
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const Facet& facet = facets[f];
            const auto& [a, b, c] = facet.number;
            const Half_facet h = 4 * cells[f];
            auto& cell = g.cells[cells[f]];
            cell.vertex = {v, facet.vertex[0], facet.vertex[1], facet.vertex[2]};
            cell.across[0] = facet.beyond;
            g.cells[facet.beyond >> 2].across[facet.beyond & 3U] = h;
            edge(a, b) = h + 3;
            edge(b, c) = h + 1;
            edge(c, a) = h + 2;
        }
        for (std::size_t f = 0; f < facets.size(); ++f) {
            const auto& [a, b, c] = facets[f].number;
            auto& cell = g.cells[cells[f]];
            cell.across[1] = edge(c, b);
            cell.across[2] = edge(a, c);
            cell.across[3] = edge(b, a);
        }
    });
    const std::span<const Cell> made(cells, facets.size());
    if (!cavity_edges_.has_met(g.infinity)) return cached_spheres(g, made);
    const Coordinates<3>& p = g.at(v);
    for (std::size_t f = 0; f < facets.size(); ++f)
        g.cells[cells[f]].sphere = std::apply(
            [&](auto... w) { return cached_sphere(g.lifted(w, p)..., g.bound(cells[f])); }, facets[f].vertex);
}

/// The facets of the border are in cyclic order, and so are the new cells.
template <>
void Inserter<2>::fill(Rank v) {
    constexpr int d = 2;
    Cells& g = *cells_;
    const Coordinates<d>& p = g.at(v);
    const std::size_t n = cavity_.border_size;
    std::vector<Facet>& facets = cavity_.facets;
    if (facets.size() <= n) facets.resize(2 * n);
    for (std::size_t f = 0; f < n; ++f) {
        const Half_facet h = cavity_.border[f];
        const auto& cell = g.cells[h >> 2];
        facets[f].vertex[0] = cell.vertex[next_slot<d>(h & 3U, 1)];
        facets[f].beyond = cell.across[h & 3U];
    }
    facets[n].vertex[0] = facets[0].vertex[0];
    Cell before = cavity_.cells[n - 1];
    Lifted<d> a = g.lifted(facets[0].vertex[0], p);
    for (std::size_t f = 0; f < n; ++f) {
        const Cell c = cavity_.cells[f], after = cavity_.cells[f + 1 < n ? f + 1 : 0];
        const Half_facet beyond = facets[f].beyond;
        auto& cell = g.cells[c];
        cell.vertex = {v, facets[f].vertex[0], facets[f + 1].vertex[0]};
        cell.across = {beyond, 4 * after + 2, 4 * before + 1};
        g.cells[beyond >> 2].across[beyond & 3U] = 4 * c;
        const Lifted<d> b = g.lifted(facets[f + 1].vertex[0], p);
        cell.sphere = cached_sphere(a, b, cell.bound);
        a = b;
        before = c;
    }
}

}  // namespace annulus::inline v1
