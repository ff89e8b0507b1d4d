// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/cell_table.h>
#include <annulus/cgal/types_2.h>
#include <annulus/mesh/replace_cells.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
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
        table_ = {};
        face_ = {};
    }

    /// Mirrors a changed region: old_cells have gone or changed, faces are what fills their place now (possibly the
    /// same CGAL faces). Facets on the border of the region keep their index. The cells of `faces` join `changed`.
    void replace(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces,
                 std::vector<Index>& changed);

    /// Mirrors the star of v, which CGAL has just inserted.
    void adopt_star(Vertex_handle v, std::vector<Index>& changed);

    /// Brings CGAL's faces in line with these cells of the table.
    void follow(std::span<const Index> cells, std::span<const Vertex_handle> handle);
    /// Brings these cells in line with CGAL's faces, under other numbers.
    void restore(std::span<const Index> cells, std::vector<Index>& made);

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Index index_of(Vertex_handle v) const { return tr_.is_infinite(v) ? infinite : v->index(); }
    void free_unused(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces);
    void glue(const std::vector<Face_handle>& faces, const std::vector<Index>& inside);

    Tr& tr_;
    Cell_table<2> table_;
    std::vector<Face_handle> face_;  // by cell
};

template <class Tr>
void Cgal_mirror_2<Tr>::build(std::size_t bound) {
    table_.clear(bound);
    face_.clear();
    if (tr_.dimension() != 2) return;
    face_.reserve(tr_.tds().number_of_full_dim_faces());
    for (auto f = tr_.all_faces_begin(); f != tr_.all_faces_end(); ++f) face_.push_back(f);
    table_.clear(bound, face_.size());
    for (std::size_t k = 0; k < face_.size(); ++k) face_[k]->set_cell(static_cast<Index>(k));
    for (const Face_handle f : face_) {
        const Index k = f->cell();
        for (int i = 0; i <= 2; ++i) {
            table_.set_vertex(table_.corner(k, i), index_of(f->vertex(i)));
            const Face_handle g = f->neighbor(i);
            if (g->cell() > k) table_.glue(table_.corner(k, i), table_.corner(g->cell(), tr_.tds().mirror_index(f, i)));
        }
    }
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
        if (!kept[static_cast<std::size_t>(place(c) - old.begin())]) {
            table_.free_cell(c);
            face_[at(c)] = Face_handle();
        }
}

/// Glues the facets of `faces` as CGAL has them. `inside` are the cells of the region, sorted.
template <class Tr>
void Cgal_mirror_2<Tr>::glue(const std::vector<Face_handle>& faces, const std::vector<Index>& inside) {
    for (const Face_handle f : faces)
        for (int i = 0; i <= 2; ++i) {
            const Face_handle g = f->neighbor(i);
            const Index h = table_.corner(f->cell(), i);
            const Index t = table_.corner(g->cell(), tr_.tds().mirror_index(f, i));
            if (!std::binary_search(inside.begin(), inside.end(), g->cell())) {
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
    std::vector<Index> inside;
    for (const Face_handle f : faces) {
        if (f->cell() == none) f->set_cell(table_.new_cell());
        const Index c = f->cell();
        if (at(c) >= face_.size()) face_.resize(at(c) + 1);
        face_[at(c)] = f;
        for (int i = 0; i <= 2; ++i) table_.set_vertex(table_.corner(c, i), index_of(f->vertex(i)));
        inside.push_back(c);
    }
    changed.insert(changed.end(), inside.begin(), inside.end());
    std::sort(inside.begin(), inside.end());
    glue(faces, inside);
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

template <class Tr>
void Cgal_mirror_2<Tr>::follow(std::span<const Index> cells, std::span<const Vertex_handle> handle) {
    auto& tds = tr_.tds();
    face_.resize(at(table_.cell_bound()));
    for (const Index c : cells) {
        if (table_.is_cell(c) || face_[at(c)] == Face_handle()) continue;
        tds.delete_face(face_[at(c)]);
        face_[at(c)] = Face_handle();
    }
    for (const Index c : cells) {
        if (!table_.is_cell(c)) continue;
        Face_handle& face = face_[at(c)];
        if (face == Face_handle()) face = tds.create_face();
        face->set_cell(c);
        for (int i = 0; i <= 2; ++i) {
            const Index k = table_.vertex(table_.corner(c, i));
            const Vertex_handle v = k == infinite ? tr_.infinite_vertex() : handle[at(k)];
            face->set_vertex(i, v);
            v->set_face(face);
        }
    }
    for (const Index c : cells) {
        if (!table_.is_cell(c)) continue;
        for (int i = 0; i <= 2; ++i) {
            const Index t = table_.twin(table_.corner(c, i));
            tds.set_adjacency(face_[at(c)], i, face_[at(table_.cell_of(t))], table_.slot_of(t));
        }
    }
}

template <class Tr>
void Cgal_mirror_2<Tr>::restore(std::span<const Index> cells, std::vector<Index>& made) {
    std::vector<Index> present;
    std::vector<Face_handle> theirs;
    std::vector<Cell_points<2>> vertices;
    for (const Index c : cells) {
        if (table_.is_cell(c)) present.push_back(c);
        if (at(c) >= face_.size() || face_[at(c)] == Face_handle()) continue;
        theirs.push_back(std::exchange(face_[at(c)], Face_handle()));
        Cell_points<2> x{};
        for (int i = 0; i <= 2; ++i) x[static_cast<std::size_t>(i)] = index_of(theirs.back()->vertex(i));
        vertices.push_back(x);
    }
    const std::size_t first = made.size();
    replace_cells<2>(table_, present, vertices, made);
    face_.resize(at(table_.cell_bound()));
    for (std::size_t k = 0; k < theirs.size(); ++k) {
        face_[at(made[first + k])] = theirs[k];
        theirs[k]->set_cell(made[first + k]);
    }
}

}  // namespace annulus
