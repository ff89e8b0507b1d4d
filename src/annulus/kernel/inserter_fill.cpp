// SPDX-License-Identifier: GPL-3.0-or-later
// Inserter: the new cells that replace a cavity.
#include <annulus/kernel/inserter.h>

#include <annulus/kernel/cached_spheres.h>

#include <algorithm>
#include <span>
#include <tuple>

namespace annulus::inline v1 {

namespace {
template <int d>
constexpr auto others = facing<d>();
}

/// To be called before the cells of the cavity are overwritten. Returns whether infinity is on the border. A cell has
/// one vertex that the cell from which it was entered does not have.
template <int d>
bool Inserter<d>::read_border() {
    Cavity& cavity = cavity_;
    if (cavity.facets.size() < cavity.border_size) cavity.facets.resize(2 * cavity.border_size);
    bool meets_infinity = false;
    ridges_.with_numbers([&](auto number) {
        const auto meet = [&](Rank v) {
            meets_infinity |= v == cells_->infinity;
            number(v);
        };
        for (const Rank v : cells_->cells[cavity.cells[0]].vertex) meet(v);
        for (std::size_t k = 1; k < cavity.size; ++k) {
            const Half_facet h = cavity.entered[k];
            meet(cells_->cells[h >> 2].vertex[h & 3U]);
        }
    });
    for (std::size_t f = 0; f < cavity.border_size; ++f) {
        const Half_facet h = cavity.border[f];
        const auto& cell = cells_->cells[h >> 2];
        Facet& facet = cavity.facets[f];
        facet.beyond = cell.across[h & 3U];
        for (std::size_t k = 0; k < d; ++k) facet.vertex[k] = cell.vertex[others<d>[h & 3U][k]];
        for (std::size_t k = 0; k < d; ++k) facet.number[k] = ridges_.number(facet.vertex[k]);
        if constexpr (d == 2) ridges_.after(facet.number[0]) = 4 * cavity.cells[f];
    }
    return meets_infinity;
}

/// The new cells without their spheres. Each is followed by the one whose edge begins where its own ends.
template <>
void Inserter<2>::glue(Rank v, std::span<const Facet> facets) {
    Cells& g = *cells_;
    const Cell* const cells = cavity_.cells.data();
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const Facet& facet = facets[f];
        const Half_facet h = 4 * cells[f], after = ridges_.after(facet.number[1]);
        auto& cell = g.cells[cells[f]];
        cell.vertex = {v, facet.vertex[0], facet.vertex[1]};
        cell.across[0] = facet.beyond;
        g.cells[facet.beyond >> 2].across[facet.beyond & 3U] = h;
        cell.across[1] = after + 2;
        g.cells[after >> 2].across[2] = h + 1;
    }
}

template <>
void Inserter<3>::glue(Rank v, std::span<const Facet> facets) {
    Cells& g = *cells_;
    const Cell* const cells = cavity_.cells.data();
    ridges_.with_edges(facets.size(), [&](auto edge) {
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
}

template <int d>
void Inserter<d>::fill(Rank v) {
    const bool meets_infinity = read_border();
    Cells& g = *cells_;
    const std::span<const Facet> facets(cavity_.facets.data(), cavity_.border_size);
    glue(v, facets);
    const std::span<const Cell> made(cavity_.cells.data(), facets.size());
    cached_spheres(g, made);  // of infinite cells they have no meaning yet
    if (!meets_infinity) return;
    const Coordinates<d>& p = g.at(v);
    for (std::size_t f = 0; f < facets.size(); ++f) {
        const auto& w = facets[f].vertex;
        if (std::find(w.begin(), w.end(), g.infinity) != w.end())
            g.cells[made[f]].sphere =
                std::apply([&](auto... u) { return cached_sphere(g.lifted(u, p)..., g.bound(made[f])); }, w);
    }
}

template bool Inserter<2>::read_border();
template bool Inserter<3>::read_border();
template void Inserter<2>::fill(Rank);
template void Inserter<3>::fill(Rank);

}  // namespace annulus::inline v1
