// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/replace_cells.h>

#include <annulus/mesh/facet_side.h>

#include <algorithm>
#include <cassert>

namespace annulus::inline v1 {

namespace {

/// One side of a facet whose two sides are to be joined.
template <int d>
struct Side {
    std::array<Site<d>, static_cast<std::size_t>(d)> sites;  // sorted
    Corner_index half;                                       // outside the cavity, or in a fresh cell
};

}  // namespace

template <int d>
void replace_cells(Corner_table<d>& t, std::span<const Cell_index> old, std::span<const Cell_sites<d>> fresh,
                   std::vector<Cell_index>& made) {
    std::vector<Side<d>> sides;
    sides.reserve((old.size() + fresh.size()) * static_cast<std::size_t>(d + 1));
    std::vector<Cell_index> gone(old.begin(), old.end());
    std::sort(gone.begin(), gone.end());
    for (const Cell_index c : gone)
        for (int i = 0; i <= d; ++i) {
            const Corner_index h = t.corner(c, i);
            const Corner_index twin = t.twin(h);
            if (!std::binary_search(gone.begin(), gone.end(), t.cell_of(twin)))
                sides.push_back({Facet_side<d>(cell_sites(t, c), i).sites, twin});
        }
    for (const Cell_index c : gone) t.free_cell(c);
    for (const Cell_sites<d>& x : fresh) {
        const Cell_index c = t.new_cell();
        made.push_back(c);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Corner_index h = t.corner(c, static_cast<int>(i));
            t.set_site(h, x[i]);
            sides.push_back({Facet_side<d>(x, static_cast<int>(i)).sites, h});
        }
    }
    // Each facet occurs twice.
    std::sort(sides.begin(), sides.end(), [](const Side<d>& l, const Side<d>& r) { return l.sites < r.sites; });
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        assert(sides[i].sites == sides[i + 1].sites);
        t.set_adjacency(sides[i].half, sides[i + 1].half);
    }
}

template <int d>
void replace_cells(Corner_table<d>& t, std::span<const Cell_index> old, std::span<const Cell_sites<d>> fresh,
                   std::span<const Fresh_neighbours<d>> neighbours, std::vector<Cell_index>& made) {
    for (const Cell_index c : old) t.free_cell(c);
    const std::size_t first = made.size();
    for (const Cell_sites<d>& x : fresh) {
        const Cell_index c = made.emplace_back(t.new_cell());
        for (std::size_t i = 0; i < x.size(); ++i) t.set_site(t.corner(c, static_cast<int>(i)), x[i]);
    }
    for (std::size_t k = 0; k < fresh.size(); ++k)
        for (std::size_t i = 0; i <= d; ++i) {
            const auto& [other, beyond] = neighbours[k][i];
            const Corner_index own = t.corner(made[first + k], static_cast<int>(i));
            if (beyond != no_corner) {
                t.set_adjacency(own, beyond);
                continue;
            }
            assert(neighbours[other / 4][other % 4].fresh == 4 * k + i);
            t.set_adjacency(own, t.corner(made[first + other / 4], static_cast<int>(other % 4)));
        }
}

template void replace_cells<2>(Corner_table<2>&, std::span<const Cell_index>, std::span<const Cell_sites<2>>,
                               std::vector<Cell_index>&);
template void replace_cells<3>(Corner_table<3>&, std::span<const Cell_index>, std::span<const Cell_sites<3>>,
                               std::vector<Cell_index>&);
template void replace_cells<2>(Corner_table<2>&, std::span<const Cell_index>, std::span<const Cell_sites<2>>,
                               std::span<const Fresh_neighbours<2>>, std::vector<Cell_index>&);
template void replace_cells<3>(Corner_table<3>&, std::span<const Cell_index>, std::span<const Cell_sites<3>>,
                               std::span<const Fresh_neighbours<3>>, std::vector<Cell_index>&);

}  // namespace annulus::inline v1
