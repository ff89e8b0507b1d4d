// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding_3: one vertex inserted, removed or moved, with CGAL.
#include <annulus/cgal/embedding_3.h>

namespace annulus {

template <class Info>
bool Cgal_embedding_3<Info>::insert(Index v, const Coordinates<3>& p, std::vector<Index>& changed) {
    typename Triangulation::Locate_type type{};
    int i = 0;
    int j = 0;
    const Cell_handle where = tr_.locate(point(p), type, i, j);
    if (type == Triangulation::VERTEX) return false;
    order_.forget();
    const int before = tr_.dimension();
    Vertex_handle inserted;
    cgal_3::with_sound_table([&] { inserted = tr_.insert(point(p), type, where, i, j); });
    inserted->set_index(v);
    if (at(v) >= handle_.size()) handle_.resize(at(v) + 1);
    handle_[at(v)] = inserted;
    if (!mirrored_) return true;
    if (before == 3) {
        table_.set_vertex_bound(handle_.size());
        adopt(star(inserted), changed);
    } else {
        mirror();
    }
    return true;
}

template <class Info>
void Cgal_embedding_3<Info>::remove(Index v, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    order_.forget();
    if (mirrored_ && detach(v, changed)) {
        tr_.tds().delete_vertex(handle);
        handle_[at(v)] = Vertex_handle();
        return;
    }
    shuffled_ = true;
    cgal_3::with_sound_table([&] { tr_.remove(handle); });
    handle_[at(v)] = Vertex_handle();
    if (mirrored_) mirror();
}

template <class Info>
Relocation Cgal_embedding_3<Info>::relocate(Index v, const Coordinates<3>& p) {
    const Vertex_handle handle = handle_[at(v)];
    typename Triangulation::Locate_type type{};
    int i = 0;
    int j = 0;
    const Cell_handle where = tr_.locate(point(p), type, i, j, handle->cell());
    if (type == Triangulation::VERTEX) return where->vertex(i) == handle ? Relocation::kept : Relocation::refused;
    if (tr_.dimension() != 3) {
        // CGAL's vertices of lower dimensions are few ways to get wrong: all anew.
        std::vector<Coordinates<3>> x(handle_.size());
        for (std::size_t k = 0; k < x.size(); ++k)
            if (handle_[k] != Vertex_handle()) x[k] = coordinates(handle_[k]->point());
        x[at(v)] = p;
        rebuild(x);
        return Relocation::reinserted;
    }
    Vertex_handle inserted;
    cgal_3::with_sound_table([&] { inserted = tr_.insert(point(p), type, where, i, j); });
    // The handle moves to the new star and the newcomer to the old one, where it is removed.
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    substitute(inserted, handle);
    handle->set_point(point(p));
    tr_.tds().delete_vertex(inserted);
    shuffled_ = true;
    std::vector<Cell_handle> cells;
    cgal_3::with_sound_table([&] { tr_.remove_and_give_new_cells(stand_in, std::back_inserter(cells)); });
    if (tr_.dimension() == 3) put_in_order(cells);  // what is computed from their corners is the same in another run
    return Relocation::reinserted;
}

template <class Info>
Relocation Cgal_embedding_3<Info>::relocate_by_flips(Index v, const Coordinates<3>& p) {
    return update_in_place(v, p) ? Relocation::kept : relocate(v, p);
}

/// All certificates of v are evaluated; where only one vertex moves and its cells stay positive nothing can wind twice.
template <class Info>
bool Cgal_embedding_3<Info>::update_in_place(Index v, const Coordinates<3>& p) {
    if (tr_.dimension() != 3) return false;
    const Vertex_handle handle = handle_[at(v)];
    const Point old = handle->point();
    handle->set_point(point(p));
    bool holds = true;
    for (const Cell_handle c : star(handle)) holds = holds && cell_verdict(c).sign > 0;
    if (holds) for_each_facet_around(handle, [&](const Facet& f) { holds = holds && facet_verdict(f).sign > 0; });
    if (!holds) handle->set_point(old);
    return holds;
}

}  // namespace annulus
