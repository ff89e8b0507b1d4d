// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding_3: the flat mirror, and every change made to both.
#include <annulus/cgal/embedding_3.h>
#include <annulus/mesh/replace_cells.h>

#include <algorithm>

namespace annulus {

template <class Info>
void Cgal_embedding_3<Info>::mirror() {
    cell_.clear();
    mark_.clear();
    mirrored_ = true;
    if (tr_.dimension() != 3) {
        table_.clear(handle_.size());
        return;
    }
    // Numbered as they come, which is nearly in the order of insertion, a curve through space; unless where they are in memory has
    // a say in that.
    cell_.reserve(tr_.tds().number_of_cells());
    for (auto c = tr_.all_cells_begin(); c != tr_.all_cells_end(); ++c) cell_.push_back(c);
    if (shuffled_) put_in_order(cell_);
    table_.clear(handle_.size(), cell_.size());
    for (std::size_t k = 0; k < cell_.size(); ++k) cell_[k]->set_cell(static_cast<Index>(k));
    for (const Cell_handle c : cell_) {
        const Index k = c->cell();
        for (int i = 0; i <= 3; ++i) {
            table_.set_vertex(table_.corner(k, i), index_of(tr_, c->vertex(i)));
            const Cell_handle n = c->neighbor(i);
            if (n->cell() > k) table_.glue(table_.corner(k, i), table_.corner(n->cell(), slot_of_facet(n, c, i)));
        }
    }
}

/// Where the facet opposite to vertex i of c is in its neighbour n. CGAL's mirror_index takes the first facet that they share; where tolerances
/// are not certified they may share two.
template <class Info>
int Cgal_embedding_3<Info>::slot_of_facet(Cell_handle n, Cell_handle c, int i) {
    int slot = n->index(c);
    while (slot < 3 && c->has_vertex(n->vertex(slot)) && n->vertex(slot) != c->vertex(i)) {
        int next = slot + 1;
        while (next < 4 && n->neighbor(next) != c) ++next;
        if (next == 4) break;
        slot = next;
    }
    return slot;
}

/// CGAL's removal goes through a map ordered by addresses, so in which order its cells come, and their corners, is not the same
/// in another run of the program. Ours is: the least index first, of the others the least next; infinity is -1. The corners are
/// turned by even permutations, so the cell stays what it is.
template <class Info>
auto Cgal_embedding_3<Info>::put_in_order(Cell_handle c) -> Ordered_cell {
    std::array<Index, 4> v{};
    for (std::size_t i = 0; i < 4; ++i) v[i] = index_of(tr_, c->vertex(static_cast<int>(i)));
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
    return {{v[from[0]], v[from[1]], v[from[2]], v[from[3]]}, c};
}

template <class Info>
void Cgal_embedding_3<Info>::put_in_order(std::vector<Cell_handle>& cells) {
    std::vector<Ordered_cell> ordered;
    for (const Cell_handle c : cells) ordered.push_back(put_in_order(c));
    std::sort(ordered.begin(), ordered.end());
    for (std::size_t k = 0; k < cells.size(); ++k) cells[k] = ordered[k].cell;
}

/// The mirror of one cell, its facets not glued yet.
template <class Info>
Index Cgal_embedding_3<Info>::new_cell(Cell_handle c) {
    const Index n = table_.new_cell();
    c->set_cell(n);
    if (at(n) >= cell_.size()) cell_.resize(at(n) + 1);
    cell_[at(n)] = c;
    for (int i = 0; i <= 3; ++i) table_.set_vertex(table_.corner(n, i), index_of(tr_, c->vertex(i)));
    return n;
}

/// The cells of the mirror whose place these cells of CGAL have taken: all behind their outer facets. mark_ is 1 for them.
template <class Info>
std::vector<Index> Cgal_embedding_3<Info>::cells_replaced_by(const std::vector<Cell_handle>& cells) {
    mark_.resize(at(table_.cell_bound()), 0);
    std::vector<Index> old;
    std::vector<Index> outside;  // half-facets
    for (const Cell_handle c : cells)
        for (int i = 0; i <= 3; ++i) {
            const Cell_handle g = c->neighbor(i);
            if (g->cell() == none) continue;
            outside.push_back(table_.corner(g->cell(), tr_.tds().mirror_index(c, i)));
        }
    std::sort(outside.begin(), outside.end());
    const auto enter = [&](Index c) {
        if (mark_[at(c)] != 0) return;
        mark_[at(c)] = 1;
        old.push_back(c);
    };
    for (const Index h : outside) enter(table_.cell_of(table_.twin(h)));
    for (std::size_t k = 0; k < old.size(); ++k)
        for (int i = 0; i <= 3; ++i) {
            const Index t = table_.twin(table_.corner(old[k], i));
            if (!std::binary_search(outside.begin(), outside.end(), t)) enter(table_.cell_of(t));
        }
    return old;
}

/// Mirrors a changed region: `cells` are what CGAL put there, new ones all. Facets on the border keep their index.
template <class Info>
void Cgal_embedding_3<Info>::adopt(std::vector<Cell_handle> cells, std::vector<Index>& changed) {
    put_in_order(cells);
    const std::vector<Index> old = cells_replaced_by(cells);
    for (const Index c : old)
        for (int i = 0; i <= 3; ++i) {
            const Index h = table_.corner(c, i);
            const Index t = table_.twin(h);
            if (h < t && mark_[at(table_.cell_of(t))] != 0) table_.free_facet(table_.facet(h));
        }
    for (const Index c : old) {
        mark_[at(c)] = 0;
        cell_[at(c)] = Cell_handle();
        table_.free_cell(c);
    }
    std::vector<Facet> outer;  // what lies outside, before the new cells have numbers
    std::vector<Facet> border;
    for (const Cell_handle c : cells)
        for (int i = 0; i <= 3; ++i)
            if (c->neighbor(i)->cell() != none) {
                border.emplace_back(c, i);
                outer.emplace_back(c->neighbor(i), tr_.tds().mirror_index(c, i));
            }
    for (const Cell_handle c : cells) changed.push_back(new_cell(c));
    for (std::size_t k = 0; k < border.size(); ++k) {
        const Index t = table_.corner(outer[k].first->cell(), outer[k].second);
        table_.glue(table_.corner(border[k].first->cell(), border[k].second), t, table_.facet(t));
    }
    std::size_t next = 0;
    for (const Cell_handle c : cells)
        for (int i = 0; i <= 3; ++i) {
            if (next < border.size() && border[next] == Facet(c, i)) {
                ++next;
                continue;
            }
            const Index h = table_.corner(c->cell(), i);
            const Index t = table_.corner(c->neighbor(i)->cell(), tr_.tds().mirror_index(c, i));
            if (h < t) table_.glue(h, t);
        }
}

template <class Info>
void Cgal_embedding_3<Info>::follow(std::span<const Index> cells) {
    auto& tds = tr_.tds();
    cell_.resize(at(table_.cell_bound()));
    for (const Index c : cells) {
        if (table_.is_cell(c) || cell_[at(c)] == Cell_handle()) continue;
        tds.delete_cell(cell_[at(c)]);
        cell_[at(c)] = Cell_handle();
    }
    for (const Index c : cells) {
        if (!table_.is_cell(c)) continue;
        Cell_handle& cell = cell_[at(c)];
        if (cell == Cell_handle()) cell = tds.create_cell();
        cell->set_cell(c);
        for (int i = 0; i <= 3; ++i) {
            const Vertex_handle v = vertex_of(table_.vertex(table_.corner(c, i)));
            cell->set_vertex(i, v);
            v->set_cell(cell);
        }
    }
    for (const Index c : cells) {
        if (!table_.is_cell(c)) continue;
        for (int i = 0; i <= 3; ++i) {
            const Index t = table_.twin(table_.corner(c, i));
            tds.set_adjacency(cell_[at(c)], i, cell_[at(table_.cell_of(t))], table_.slot_of(t));
        }
    }
}

template <class Info>
bool Cgal_embedding_3<Info>::delaunay_of(std::span<const Coordinates<3>> x, std::span<const Index> vertices,
                                         std::vector<Cell_points<3>>& cells) {
    Plain tr;
    cgal_3::with_sound_table([&] {
        typename Plain::Vertex_handle hint;
        for (const Index i : vertices) {
            hint = hint == typename Plain::Vertex_handle() ? tr.insert(point(x[at(i)])) : tr.insert(point(x[at(i)]), hint);
            hint->set_index(i);
        }
    });
    if (tr.dimension() != 3 || tr.number_of_vertices() != vertices.size()) return false;
    for (auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c) {
        Cell_points<3> v{};
        for (int i = 0; i <= 3; ++i) v[static_cast<std::size_t>(i)] = index_of(tr, c->vertex(i));
        cells.push_back(v);
    }
    return true;
}

template <class Info>
void Cgal_embedding_3<Info>::restore_cells(std::span<const Index> cells, std::vector<Index>& made) {
    std::vector<Index> present;
    std::vector<Cell_handle> theirs;
    std::vector<Cell_points<3>> vertices;
    for (const Index c : cells) {
        if (table_.is_cell(c)) present.push_back(c);
        if (at(c) >= cell_.size() || cell_[at(c)] == Cell_handle()) continue;
        theirs.push_back(std::exchange(cell_[at(c)], Cell_handle()));
        Cell_points<3> x{};
        for (int i = 0; i <= 3; ++i) x[static_cast<std::size_t>(i)] = index_of(tr_, theirs.back()->vertex(i));
        vertices.push_back(x);
    }
    const std::size_t first = made.size();
    replace_cells<3>(table_, present, vertices, made);
    cell_.resize(at(table_.cell_bound()));
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        cell_[at(made[first + k])] = theirs[k];
        theirs[k]->set_cell(made[first + k]);
    }
}

template <class Info>
bool Cgal_embedding_3<Info>::reinsert(Index v, const Coordinates<3>& p, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    const Coordinates<3> home = coordinates(handle->point());
    Vertex_handle near;
    for (int i = 0; i <= 3; ++i)
        if (const Vertex_handle w = handle->cell()->vertex(i); w != handle && !tr_.is_infinite(w)) near = w;
    if (!detach(v, changed)) return false;
    if (attach(v, p, near, changed)) return true;
    (void)attach(v, home, near, changed);
    throw Error(Error_code::collision, "another vertex is at that position");
}

template <class Info>
bool Cgal_embedding_3<Info>::attach(Index v, const Coordinates<3>& p, Vertex_handle near, std::vector<Index>& changed) {
    typename Triangulation::Locate_type type{};
    int i = 0;
    int j = 0;
    const Cell_handle where = tr_.locate(point(p), type, i, j, near->cell());
    if (type == Triangulation::VERTEX) return false;
    Vertex_handle inserted;
    cgal_3::with_sound_table([&] { inserted = tr_.insert(point(p), type, where, i, j); });
    const Vertex_handle handle = handle_[at(v)];
    substitute(inserted, handle);
    handle->set_point(point(p));
    tr_.tds().delete_vertex(inserted);
    adopt(star(handle), changed);
    return true;
}

/// Not CGAL's `incident_cells`, which marks the cells and so is no reading for several threads. Precondition: dimension 3.
template <class Info>
auto Cgal_embedding_3<Info>::star(Vertex_handle v) const -> std::vector<Cell_handle> {
    std::vector<Cell_handle> cells{v->cell()};
    Small_set<Cell_handle, Handle_hash> met{Cell_handle()};
    met.insert(v->cell());
    for (std::size_t k = 0; k < cells.size(); ++k)
        for (int i = 0; i <= 3; ++i) {
            const Cell_handle c = cells[k]->neighbor(i);
            if (cells[k]->vertex(i) != v && met.insert(c)) cells.push_back(c);
        }
    return cells;
}

/// Puts `replacement` in the place of `old` in every incident cell.
template <class Info>
void Cgal_embedding_3<Info>::substitute(Vertex_handle old, Vertex_handle replacement) {
    replacement->set_cell(old->cell());
    for (const Cell_handle c : star(old)) c->set_vertex(c->index(old), replacement);
}

/// Whether all vertices but v are coplanar. O(1) unless every finite cell contains v.
template <class Info>
bool Cgal_embedding_3<Info>::rest_is_flat(Vertex_handle v) const {
    for (auto c = tr_.finite_cells_begin(); c != tr_.finite_cells_end(); ++c)
        if (!c->has_vertex(v)) return false;
    const Cell_handle first = tr_.finite_cells_begin();
    const auto& facing = facing_corners[static_cast<std::size_t>(first->index(v))];
    std::array<Coordinates<3>, 3> plane{};
    for (std::size_t k = 0; k < 3; ++k) plane[k] = coordinates(first->vertex(facing[k])->point());
    for (const Vertex_handle w : handle_) {
        if (w == Vertex_handle() || w == v || w->cell() == Cell_handle()) continue;  // vacant, or taken out
        const Coordinates<3> x = coordinates(w->point());
        if (orientation_verdict({&plane[0], &plane[1], &plane[2], &x}, false).sign != 0) return false;
    }
    return true;
}

template <class Info>
bool Cgal_embedding_3<Info>::detach(Index v, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    if (tr_.dimension() != 3 || tr_.number_of_vertices() <= 4 || rest_is_flat(handle)) return false;
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    handle->set_cell(Cell_handle());
    shuffled_ = true;
    std::vector<Cell_handle> cells;
    cgal_3::with_sound_table([&] { tr_.remove_and_give_new_cells(stand_in, std::back_inserter(cells)); });
    table_.set_absent(v);
    adopt(cells, changed);
    return true;
}

}  // namespace annulus
