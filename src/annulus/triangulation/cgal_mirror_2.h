// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/triangulation/cell_table.h>
#include <annulus/triangulation/cgal_types_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace annulus {

/// The flat mirror of CGAL's object: a Cell_table that is CGAL's corner for corner, and which face each cell mirrors.
/// A face knows its cell; `none` means that it is not mirrored yet.
template <class Tr>
class Cgal_mirror_2 {
  public:
    using Vertex_handle = typename Tr::Vertex_handle;
    using Face_handle = typename Tr::Face_handle;

    explicit Cgal_mirror_2(Tr& tr) : tr_(tr) {}
    Cgal_mirror_2(const Cgal_mirror_2&) = delete;
    Cgal_mirror_2& operator=(const Cgal_mirror_2&) = delete;

    [[nodiscard]] Cell_table<2>& table() { return table_; }
    [[nodiscard]] const Cell_table<2>& table() const { return table_; }

    /// Mirrors everything anew, for vertex indices below `bound`; nothing where the points are flat. O(n log n).
    void build(std::size_t bound);
    /// Mirrors nothing.
    void clear() noexcept {
        table_.clear(0);
        face_.clear();
    }

    /// Mirrors a changed region: old_cells have gone or changed, faces are what fills their place now (possibly the
    /// same CGAL faces). Facets on the border of the region keep their index. The cells of `faces` join `changed`.
    void replace(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces,
                 std::vector<Index>& changed);

    /// Mirrors the star of v, which CGAL has just inserted.
    void adopt_star(Vertex_handle v, std::vector<Index>& changed);

    /// Flips the facet opposite to corner h in both.
    void flip(Index h) {
        tr_.tds().flip(face_[at(table_.cell_of(h))], table_.slot_of(h));
        table_.flip(h);
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Index index_of(Vertex_handle v) const { return tr_.is_infinite(v) ? infinite : v->index(); }
    void free_unused(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces);
    void glue(const std::vector<Face_handle>& faces, const std::vector<Index>* inside);

    Tr& tr_;
    Cell_table<2> table_;
    std::vector<Face_handle> face_;  // by cell
};

template <class Tr>
void Cgal_mirror_2<Tr>::build(std::size_t bound) {
    table_.clear(bound);
    face_.clear();
    if (tr_.dimension() != 2) return;
    std::vector<Face_handle> faces;
    for (auto f = tr_.all_faces_begin(); f != tr_.all_faces_end(); ++f) {
        f->set_cell(none);
        faces.push_back(f);
    }
    // Cells and facets are numbered along the vertices, so that what is near in the plane is near in memory whenever
    // the caller's order is.
    const auto least = [this](Face_handle f) {
        return std::min({index_of(f->vertex(0)), index_of(f->vertex(1)), index_of(f->vertex(2))});
    };
    std::sort(faces.begin(), faces.end(), [&](Face_handle f, Face_handle g) { return least(f) < least(g); });
    std::vector<Index> changed;
    replace({}, faces, changed);
}

/// Gives back the facets inside the region and the cells that no face of it keeps.
template <class Tr>
void Cgal_mirror_2<Tr>::free_unused(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces) {
    std::vector<Index> old = old_cells;
    std::sort(old.begin(), old.end());
    const auto place = [&](Index c) { return std::lower_bound(old.begin(), old.end(), c); };
    const auto is_old = [&](Index c) { return place(c) != old.end() && *place(c) == c; };
    for (const Index c : old_cells)
        for (int i = 0; i <= 2; ++i) {
            const Index h = table_.corner(c, i);
            const Index t = table_.twin(h);
            if (h < t && is_old(table_.cell_of(t))) table_.free_facet(table_.facet(h));
        }
    std::vector<char> kept(old.size(), 0);
    for (const Face_handle f : faces)
        if (f->cell() != none && is_old(f->cell())) kept[static_cast<std::size_t>(place(f->cell()) - old.begin())] = 1;
    for (const Index c : old_cells)
        if (!kept[static_cast<std::size_t>(place(c) - old.begin())]) table_.free_cell(c);
}

/// Glues the facets of `faces` as CGAL has them. `inside` are the cells of the region, sorted; null for everything.
template <class Tr>
void Cgal_mirror_2<Tr>::glue(const std::vector<Face_handle>& faces, const std::vector<Index>* inside) {
    for (const Face_handle f : faces)
        for (int i = 0; i <= 2; ++i) {
            const Face_handle g = f->neighbor(i);
            const Index h = table_.corner(f->cell(), i);
            const Index t = table_.corner(g->cell(), tr_.tds().mirror_index(f, i));
            if (inside != nullptr && !std::binary_search(inside->begin(), inside->end(), g->cell())) {
                table_.glue(h, t, table_.facet(t));
            } else if (h < t) {
                table_.glue(h, t);
            }
        }
}

template <class Tr>
void Cgal_mirror_2<Tr>::replace(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces,
                                std::vector<Index>& changed) {
    free_unused(old_cells, faces);
    for (const Face_handle f : faces) {
        if (f->cell() == none) f->set_cell(table_.new_cell());
        const Index c = f->cell();
        if (at(c) >= face_.size()) face_.resize(at(c) + 1);
        face_[at(c)] = f;
        for (int i = 0; i <= 2; ++i) table_.set_vertex(table_.corner(c, i), index_of(f->vertex(i)));
        changed.push_back(c);
    }
    if (old_cells.empty()) {
        glue(faces, nullptr);
        return;
    }
    std::vector<Index> inside = changed;
    std::sort(inside.begin(), inside.end());
    glue(faces, &inside);
}

template <class Tr>
void Cgal_mirror_2<Tr>::adopt_star(Vertex_handle v, std::vector<Index>& changed) {
    std::vector<Index> old_cells;
    std::vector<Face_handle> faces;
    auto f = tr_.incident_faces(v);
    const auto done = f;
    do {
        const Face_handle face = f;
        if (face->cell() != none) old_cells.push_back(face->cell());
        faces.push_back(face);
    } while (++f != done);
    replace(old_cells, faces, changed);
}

}  // namespace annulus
