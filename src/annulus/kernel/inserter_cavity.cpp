// SPDX-License-Identifier: GPL-3.0-or-later
// Inserter: the cells whose sphere holds a vertex, and their border.
#include <annulus/kernel/inserter.h>

#include <bit>
#include <cmath>
#include <cstdint>

namespace annulus::inline v1 {

template <int d>
void Inserter<d>::unmark() {
    if constexpr (d == 2) return;  // no cell is marked
    for (std::size_t k = 0; k < cavity_.size; ++k) {
        float& bound = cells_->bound(cavity_.entered[k] >> 2);
        bound = -bound;
    }
}

/// Cells and facets of the border are always written, and counted only if they belong: a branch would be mispredicted
/// every other time. In 3D cells that were met are marked. In 2D none is met twice: the triangles of the cavity form a
/// tree, since no vertex is inside.
template <int d>
template <bool shared>
bool Inserter<d>::find_cavity(Rank v, Cell first) {
    Cells& g = *cells_;
    const Coordinates<d> q = g.at(v);
    constexpr std::size_t room = 16;
    Cavity& cavity = cavity_;
    if (cavity.entered.size() < room) cavity.entered.resize(64);
    if (cavity.border.size() < room) cavity.border.resize(64);
    std::size_t cells = 1, facets = 0;
    bool abroad = false;
    float elsewhere;  // nothing is written in another partition
    const auto test = [&](Half_facet h) {
        const Half_facet t = g.cells[h >> 2].across[h & 3U];
        const Cell c = t >> 2;
        const float constant = g.bound(c);
        const auto value = g.cells[c].sphere.at(Lifted<d>(q, g.at(g.cells[c].vertex[0])).from, constant);
        bool holds = value.inside();
        const bool met = d == 3 && std::signbit(constant);
        if (!value.certain() && !met) [[unlikely]]
            holds = holds_exactly(c, v);
        const bool own = !shared || partition_.has(c), comes = holds && !met && own;
        abroad = abroad || (holds && !own);
        cavity.entered[cells] = t;
        cells += std::size_t{comes};
        cavity.border[facets] = h;
        facets += std::size_t{!holds && !met};
        if constexpr (d == 3)  // not by `?:`, of which compilers make a branch
            (own ? g.bound(c) : elsewhere) =
                std::bit_cast<float>(std::bit_cast<std::uint32_t>(constant) ^ std::uint32_t{comes} << 31);
    };
    cavity.entered[0] = 4 * first;
    if constexpr (d == 3) g.bound(first) = -g.bound(first);
    for (std::uint32_t i = 0; i <= d; ++i) test(4 * first + i);
    const auto test_others = [&](Half_facet h) {
        for (std::uint32_t i = 1; i <= d; ++i) test((h & ~3U) | next_slot<d>(h & 3U, i));
    };
    for (std::size_t k = 1; k < cells && !(shared && abroad);) {
        if (cells + room > cavity.entered.size()) cavity.entered.resize(2 * cavity.entered.size());
        if (facets + room > cavity.border.size()) cavity.border.resize(2 * cavity.border.size());
        const Half_facet h = cavity.entered[k], after = cavity.entered[k + 1];
        const bool two = k + 1 < cells;
        test_others(h);
        ++k;
        if (two) test_others(after), ++k;
    }
    cavity.size = cells;
    cavity.border_size = facets;
    if (shared && abroad) return unmark(), false;
    if (cavity.cells.size() < cells) cavity.cells.resize(2 * cells);
    for (std::size_t k = 0; k < cells; ++k) cavity.cells[k] = cavity.entered[k] >> 2;
    return true;
}

template void Inserter<2>::unmark();
template void Inserter<3>::unmark();
template bool Inserter<2>::find_cavity<false>(Rank, Cell);
template bool Inserter<2>::find_cavity<true>(Rank, Cell);
template bool Inserter<3>::find_cavity<false>(Rank, Cell);
template bool Inserter<3>::find_cavity<true>(Rank, Cell);

}  // namespace annulus::inline v1
