// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/types_2.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace annulus::cgal_2 {

/// Gives the vertices of tr, which callers hold handles of, the faces and points of another triangulation of the same set, whose
/// vertices know their index into `handle`.
template <class Tr>
void take_faces(Tr& tr, Tr& other, std::span<const typename Tr::Vertex_handle> handle) noexcept {
    using Vertex_handle = typename Tr::Vertex_handle;
    auto& tds = tr.tds();
    tds.faces().swap(other.tds().faces());
    tds.set_dimension(other.dimension());
    const auto ours = [&](Vertex_handle v) -> Vertex_handle {
        return v == other.infinite_vertex() ? tr.infinite_vertex() : handle[static_cast<std::size_t>(v->index())];
    };
    const int last = std::max(tds.dimension(), 0);
    for (auto f = tds.faces().begin(); f != tds.faces().end(); ++f)
        for (int i = 0; i <= last; ++i)
            if (f->vertex(i) != Vertex_handle()) f->set_vertex(i, ours(f->vertex(i)));
    for (auto v = other.tds().vertices().begin(); v != other.tds().vertices().end(); ++v) {
        const Vertex_handle to = ours(v);
        to->set_face(v->face());
        if (to != tr.infinite_vertex()) to->set_point(v->point());
    }
    other.tds().faces().clear();  // ours of before, whose vertices are not theirs
    other.tds().set_dimension(-2);
}

}  // namespace annulus::cgal_2
