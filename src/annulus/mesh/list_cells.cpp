// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/list_cells.h>

#include <annulus/mesh/certificates.h>
#include <annulus/mesh/corner_table.h>

#include <algorithm>

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
Mesh_cells<d> without_neighbours(std::span<const Index> corners) {
    constexpr auto k = static_cast<std::size_t>(d + 1);
    Mesh_cells<d> out;
    out.vertices.resize(corners.size() / k);
    out.neighbours.resize(out.vertices.size());
    for (std::size_t c = 0; c < out.vertices.size(); ++c) {
        std::copy_n(&corners[c * k], k, out.vertices[c].begin());
        out.neighbours[c].fill(out.outside);
    }
    return out;
}

template Mesh_cells<2> mesh_cells<2>(const Corner_table<2>&);
template Mesh_cells<3> mesh_cells<3>(const Corner_table<3>&);
template Mesh_cells<2> without_neighbours<2>(std::span<const Index>);
template Mesh_cells<3> without_neighbours<3>(std::span<const Index>);

}  // namespace annulus::inline v1
