// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/replace_cells.h>

#include <algorithm>
#include <cassert>

namespace annulus {

namespace {

/// One side of a facet that is to be glued.
template <int d>
struct Side {
    std::array<Index, static_cast<std::size_t>(d)> vertices;  // sorted
    Corner_index half;                                        // outside the region, or in a fresh cell
};

template <int d>
Side<d> side(const Cell_points<d>& x, std::size_t slot, Corner_index half) {
    Side<d> s{{}, half};
    for (std::size_t k = 0, n = 0; k < x.size(); ++k)
        if (k != slot) s.vertices[n++] = x[k];
    std::sort(s.vertices.begin(), s.vertices.end());
    return s;
}

}  // namespace

template <int d>
void replace_cells(Cell_table<d>& t, std::span<const Cell_index> old, std::span<const Cell_points<d>> fresh,
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
                sides.push_back(side<d>(cell_points(t, c), static_cast<std::size_t>(i), twin));
        }
    for (const Cell_index c : gone) t.free_cell(c);
    for (const Cell_points<d>& x : fresh) {
        const Cell_index c = t.new_cell();
        made.push_back(c);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Corner_index h = t.corner(c, static_cast<int>(i));
            t.set_vertex(h, x[i]);
            sides.push_back(side<d>(x, i, h));
        }
    }
    // Each occurs twice.
    std::sort(sides.begin(), sides.end(), [](const Side<d>& l, const Side<d>& r) { return l.vertices < r.vertices; });
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        assert(sides[i].vertices == sides[i + 1].vertices);
        t.glue(sides[i].half, sides[i + 1].half);
    }
}

template void replace_cells<2>(Cell_table<2>&, std::span<const Cell_index>, std::span<const Cell_points<2>>,
                               std::vector<Cell_index>&);
template void replace_cells<3>(Cell_table<3>&, std::span<const Cell_index>, std::span<const Cell_points<3>>,
                               std::vector<Cell_index>&);

}  // namespace annulus
