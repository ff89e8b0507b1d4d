// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding: the flat mirror, and every change made to both.
#include <annulus/cgal/copy_cells.h>
#include <annulus/cgal/embedding.h>

#include <algorithm>

namespace annulus {

template <class Traits>
void Cgal_embedding<Traits>::mirror() {
    cell_.clear();
    mirrored_ = true;
    table_.clear(handle_.size());
    if (tr_.dimension() != d) return;
    // Numbered as they come, which is nearly in the order of insertion, a curve through space; unless where they are in memory has
    // a say in that.
    cell_.reserve(Traits::cells(tr_.tds()).size());
    Traits::for_each_cell(tr_, [&](Cell_handle c) { cell_.push_back(c); });
    if (shuffled_) put_in_order(cell_);
    copy_cells<Traits>(tr_, cell_, handle_.size(), table_, this->threads_);
}

template <class Traits>
void Cgal_embedding<Traits>::drop_mirror() noexcept {
    mirrored_ = false;
    table_.become({});
    release(cell_);
}

/// Corners in an order that depends on the vertices of a cell alone, which they are and their orientation, and cells in the order of
/// these: the least index first, of the others the least next; infinity is -1. The corners are turned by even permutations, so the
/// cell stays what it is.
template <class Traits>
void Cgal_embedding<Traits>::put_in_order(std::vector<Cell_handle>& cells) const {
    if constexpr (Traits::shuffles) {
        std::vector<std::pair<Points, Cell_handle>> ordered;
        ordered.reserve(cells.size());
        for (const Cell_handle c : cells) {
            const Points v = points_of(tr_, c);
            std::array<std::size_t, 4> from{0, 1, 2, 3};
            const auto least = static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
            if (least != 0) {
                std::swap(from[0], from[least]);
                std::swap(from[least == 1 ? 2 : 1], from[least == 3 ? 2 : 3]);
            }
            while (v[from[1]] > v[from[2]] || v[from[1]] > v[from[3]])
                std::rotate(from.begin() + 1, from.begin() + 2, from.end());
            if (from != std::array<std::size_t, 4>{0, 1, 2, 3}) {
                std::array<Vertex_handle, 4> vertex;
                std::array<Cell_handle, 4> neighbour;
                for (std::size_t i = 0; i < 4; ++i) {
                    vertex[i] = c->vertex(static_cast<int>(from[i]));
                    neighbour[i] = c->neighbor(static_cast<int>(from[i]));
                }
                c->set_vertices(vertex[0], vertex[1], vertex[2], vertex[3]);
                c->set_neighbors(neighbour[0], neighbour[1], neighbour[2], neighbour[3]);
            }
            ordered.emplace_back(Points{v[from[0]], v[from[1]], v[from[2]], v[from[3]]}, c);
        }
        std::sort(ordered.begin(), ordered.end(), [](const auto& l, const auto& r) { return l.first < r.first; });
        for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = ordered[k].second;
    }
}

/// Adds the cells of the mirror whose place these cells of CGAL, which have no number, have taken: all behind their outer facets.
template <class Traits>
void Cgal_embedding<Traits>::join_replaced(const std::vector<Cell_handle>& cells, std::vector<Cell_index>& old) {
    std::vector<Corner_index> outside;  // half-facets
    for (const Cell_handle c : cells)
        for (int i = 0; i <= d; ++i)
            if (const Cell_index g = number_of(c->neighbor(i)); g != no_cell)
                outside.push_back(table_.corner(g, Traits::slot_beyond(tr_.tds(), c, i)));
    std::sort(outside.begin(), outside.end());
    Small_set<Cell_index, Index_hash> met(no_cell);
    for (const Cell_index c : old) met.insert(c);
    const auto enter = [&](Cell_index c) {
        if (met.insert(c)) old.push_back(c);
    };
    for (const Corner_index h : outside) enter(table_.cell_of(table_.twin(h)));
    for (std::size_t k = 0; k < old.size(); ++k)
        for (int i = 0; i <= d; ++i) {
            const Corner_index t = table_.twin(table_.corner(old[k], i));
            if (!std::binary_search(outside.begin(), outside.end(), t)) enter(table_.cell_of(t));
        }
}

/// Mirrors a changed region: `cells` are what CGAL has there now, those of `old` were there before; not all need be named.
template <class Traits>
void Cgal_embedding<Traits>::adopt(std::vector<Cell_handle> cells, std::vector<Cell_index> old,
                                   std::vector<Cell_index>& changed) {
    put_in_order(cells);
    for (const Cell_handle c : cells) set_number(c, no_cell);  // CGAL makes new cells of old ones
    join_replaced(cells, old);
    std::vector<Points> vertices;
    vertices.reserve(cells.size());
    for (const Cell_handle c : cells) vertices.push_back(points_of(tr_, c));
    for (const Cell_index c : old) cell_[c] = Cell_handle();
    const std::size_t first = changed.size();
    replace_cells<d>(table_, old, vertices, changed);
    grow(cell_, table_.cell_bound());
    for (std::size_t k = 0; k < cells.size(); ++k) {
        cell_[changed[first + k]] = cells[k];
        set_number(cells[k], changed[first + k]);
    }
}

template <class Traits>
void Cgal_embedding<Traits>::follow(std::span<const Cell_index> cells) {
    auto& tds = tr_.tds();
    grow(cell_, table_.cell_bound());
    for (const Cell_index c : cells) {
        if (table_.is_cell(c) || cell_[c] == Cell_handle()) continue;
        Traits::delete_cell(tds, cell_[c]);
        cell_[c] = Cell_handle();
    }
    for (const Cell_index c : cells) {
        if (!table_.is_cell(c)) continue;
        Cell_handle& cell = cell_[c];
        if (cell == Cell_handle()) cell = Traits::create_cell(tds);
        set_number(cell, c);
        for (int i = 0; i <= d; ++i) {
            const Vertex_handle v = vertex_of(table_.vertex(table_.corner(c, i)));
            cell->set_vertex(i, v);
            Traits::set_cell_of(v, cell);
        }
    }
    for (const Cell_index c : cells) {
        if (!table_.is_cell(c)) continue;
        for (int i = 0; i <= d; ++i) {
            const Corner_index t = table_.twin(table_.corner(c, i));
            tds.set_adjacency(cell_[c], i, cell_[table_.cell_of(t)], table_.slot_of(t));
        }
    }
}

template <class Traits>
void Cgal_embedding<Traits>::restore_cells(std::span<const Coordinates<d>>, std::span<const Cell_index> cells,
                                             std::vector<Cell_index>& made) {
    std::vector<Cell_index> present;
    std::vector<Cell_handle> theirs;
    std::vector<Points> vertices;
    for (const Cell_index c : cells) {
        if (table_.is_cell(c)) present.push_back(c);
        if (!cell_.has(c) || cell_[c] == Cell_handle()) continue;
        theirs.push_back(std::exchange(cell_[c], Cell_handle()));
        vertices.push_back(points_of(tr_, theirs.back()));
    }
    const std::size_t first = made.size();
    replace_cells<d>(table_, present, vertices, made);
    grow(cell_, table_.cell_bound());
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        cell_[made[first + k]] = theirs[k];
        set_number(theirs[k], made[first + k]);
    }
}

}  // namespace annulus
