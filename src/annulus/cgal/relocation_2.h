// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/star_2.h>
#include <annulus/engine/embedding.h>

#include <vector>

namespace annulus::cgal_2 {

// Moves of one vertex in CGAL's object alone, which is Delaunay before and after. The handle stays.

/// Puts `replacement` in the place of `old` in every incident face.
template <class Tr>
void substitute(Tr& tr, typename Tr::Vertex_handle old, typename Tr::Vertex_handle replacement) {
    std::vector<typename Tr::Face_handle> star;
    auto f = tr.incident_faces(old);
    const auto done = f;
    do star.push_back(f);
    while (++f != done);
    replacement->set_face(old->face());
    for (const auto g : star) g->set_vertex(g->index(old), replacement);
}

/// The paper's baseline: locate, insert, remove.
template <class Tr>
[[nodiscard]] Relocation relocate(Tr& tr, typename Tr::Vertex_handle v, const typename Tr::Point& p) {
    if (tr.dimension() != 2) return tr.move_if_no_collision(v, p) == v ? Relocation::reinserted : Relocation::refused;
    typename Tr::Locate_type type{};
    int i = 0;
    const auto face = tr.locate(p, type, i, v->face());
    if (type == Tr::VERTEX) return face->vertex(i) == v ? Relocation::kept : Relocation::refused;
    const auto inserted = tr.insert(p, type, face, i);
    // The handle moves to the new star and the newcomer to the old one, where it is removed.
    const auto stand_in = tr.tds().create_vertex();
    stand_in->set_point(v->point());
    substitute(tr, v, stand_in);
    substitute(tr, inserted, v);
    v->set_point(p);
    tr.tds().delete_vertex(inserted);
    tr.remove(stand_in);
    return Relocation::reinserted;
}

/// Section 3.1 of the paper, as CGAL does it: flips when no incident triangle inverts, else relocation. CGAL does not tell which
/// it was, so its first question is asked beforehand.
template <class Tr>
[[nodiscard]] Relocation relocate_by_flips(Tr& tr, typename Tr::Vertex_handle v, const typename Tr::Point& p) {
    bool flips = false;
    if (tr.dimension() == 2) {
        const typename Tr::Point old = v->point();
        v->set_point(p);
        flips = tr.well_oriented(v);
        v->set_point(old);
    }
    if (tr.move_if_no_collision(v, p) != v) return Relocation::refused;
    return flips ? Relocation::flipped : Relocation::reinserted;
}

/// Writes the point of v when no topological change is needed. False, with nothing changed, when one is.
template <class Tr>
[[nodiscard]] bool update_in_place(Tr& tr, typename Tr::Vertex_handle v, const typename Tr::Point& p) {
    if (tr.dimension() != 2) return false;
    const typename Tr::Point old = v->point();
    v->set_point(p);
    if (star_holds(tr, v)) return true;
    v->set_point(old);
    return false;
}

}  // namespace annulus::cgal_2
