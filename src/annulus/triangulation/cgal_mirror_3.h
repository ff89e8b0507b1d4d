// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding_3: the flat mirror, and every change made to both.
#include <annulus/triangulation/cgal_embedding_3.h>

#include <algorithm>

namespace annulus {

template <class Info>
void Cgal_embedding_3<Info>::mirror() {
    table_.clear(handle_.size());
    cell_.clear();
    mark_.clear();
    mirrored_ = true;
    if (tr_.dimension() != 3) return;
    // Numbered along the vertices, so that what is near in space is near in memory whenever the caller's order is.
    std::vector<Ordered_cell> cells;
    cells.reserve(tr_.tds().number_of_cells());
    for (auto c = tr_.all_cells_begin(); c != tr_.all_cells_end(); ++c) {
        c->set_cell(none);
        cells.push_back(put_in_order(c));
    }
    std::sort(cells.begin(), cells.end());
    for (const auto& [vertices, c] : cells) new_cell(c);
    for (const auto& [vertices, c] : cells)
        for (int i = 0; i <= 3; ++i) {
            const Index h = table_.corner(c->cell(), i);
            const Index t = table_.corner(c->neighbor(i)->cell(), tr_.tds().mirror_index(c, i));
            if (h < t) table_.glue(h, t);
        }
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
void Cgal_embedding_3<Info>::replace(std::span<const Index> old, std::span<const std::array<Index, 4>> fresh,
                                     std::vector<Index>& created) {
    auto& tds = tr_.tds();
    using Triple = std::array<Index, 3>;
    struct Side {
        Triple vertices;  // sorted
        Index half;       // outside the region, or in a fresh cell
        Index facet;      // none: within the region
    };
    const auto triple = [](const auto& vertex, int i) {
        Triple t{};
        for (std::size_t k = 0, n = 0; k < 4; ++k)
            if (static_cast<int>(k) != i) t[n++] = vertex[k];
        std::sort(t.begin(), t.end());
        return t;
    };
    std::vector<Side> sides;
    const auto is_old = [&](Index c) { return std::find(old.begin(), old.end(), c) != old.end(); };
    for (const Index c : old)
        for (int i = 0; i <= 3; ++i) {
            const Index h = table_.corner(c, i);
            const Index t = table_.twin(h);
            if (!is_old(table_.cell_of(t))) {
                sides.push_back({triple(cell_points(table_, c), i), t, table_.facet(t)});
            } else if (h < t) {
                table_.free_facet(table_.facet(h));
            }
        }
    for (const Index c : old) {
        tds.delete_cell(cell_[at(c)]);
        cell_[at(c)] = Cell_handle();
        table_.free_cell(c);
    }
    for (const auto& v : fresh) {
        const Cell_handle c = tds.create_cell(vertex_of(v[0]), vertex_of(v[1]), vertex_of(v[2]), vertex_of(v[3]));
        const Index n = new_cell(c);
        created.push_back(n);
        for (int i = 0; i <= 3; ++i) {
            c->vertex(i)->set_cell(c);
            const Triple key = triple(v, i);
            const Index h = table_.corner(n, i);
            const auto side =
                std::find_if(sides.begin(), sides.end(), [&](const Side& s) { return s.vertices == key; });
            if (side == sides.end()) {
                sides.push_back({key, h, none});
                continue;
            }
            table_.glue(h, side->half, side->facet);
            tds.set_adjacency(c, i, cell_[at(table_.cell_of(side->half))], table_.slot_of(side->half));
            sides.erase(side);
        }
    }
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
    Index neighbour = none;
    const Cell_handle near = handle->cell();
    for (int i = 0; i <= 3; ++i)
        if (near->vertex(i) != handle && !tr_.is_infinite(near->vertex(i))) neighbour = near->vertex(i)->index();
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    handle->set_cell(Cell_handle());
    std::vector<Cell_handle> cells;
    cgal_3::with_sound_table([&] { tr_.remove_and_give_new_cells(stand_in, std::back_inserter(cells)); });
    table_.set_absent(v);
    adopt(cells, changed);
    detached_.emplace_back(v, neighbour);
    return true;
}

template <class Info>
bool Cgal_embedding_3<Info>::attach(Index v, const Coordinates<3>& p, std::vector<Index>& changed) {
    Cell_handle start;
    const auto it =
        std::find_if(detached_.begin(), detached_.end(), [v](const auto& entry) { return entry.first == v; });
    if (it != detached_.end()) {
        if (it->second != none && handle_[at(it->second)] != Vertex_handle()) start = handle_[at(it->second)]->cell();
        detached_.erase(it);
    }
    typename Triangulation::Locate_type type{};
    int i = 0;
    int j = 0;
    const Cell_handle where = tr_.locate(point(p), type, i, j, start);
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

}  // namespace annulus
