// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/build_2.h>
#include <annulus/cgal/insertion.h>
#include <annulus/cgal/mirror_2.h>
#include <annulus/cgal/readings_2.h>
#include <annulus/cgal/relocation_2.h>
#include <annulus/engine/embedding.h>

#include <chrono>
#include <utility>

namespace annulus {

/// CGAL's 2D Delaunay triangulation with its flat mirror: the only code that changes both.
template <class Info>
class Cgal_embedding_2 final : public Embedding<2> {
  public:
    static constexpr int dimension_of_space = 2;
    using Triangulation = Delaunay_2<Info>;
    using Point = typename Triangulation::Point;
    using Vertex_handle = typename Triangulation::Vertex_handle;
    using Face_handle = typename Triangulation::Face_handle;

    [[nodiscard]] static Coordinates<2> coordinates(const Point& p) { return {p.x(), p.y()}; }
    [[nodiscard]] static Point point(const Coordinates<2>& x) { return {x[0], x[1]}; }

    [[nodiscard]] const Triangulation& triangulation() const { return tr_; }
    [[nodiscard]] Triangulation& triangulation() { return tr_; }
    [[nodiscard]] Vertex_handle handle(Index v) const { return handle_[at(v)]; }
    [[nodiscard]] Index vertex_bound() const { return static_cast<Index>(handle_.size()); }

    /// Builds from nothing; vertex i is x[i]. Throws Error(collision) naming the pair when two points are equal.
    void build(std::span<const Coordinates<2>> x);
    /// (Re)builds the flat mirror from CGAL's object. O(n).
    void mirror() override;
    void drop_mirror() noexcept override;
    [[nodiscard]] bool mirrored() const override { return mirrored_; }
    void list_cells(std::vector<Index>& vertices) const override {
        for_each_finite_cell([&](const auto& cell) { vertices.insert(vertices.end(), cell.begin(), cell.end()); });
    }
    [[nodiscard]] bool has(Index v) const override { return handle_[at(v)] != Vertex_handle(); }
    [[nodiscard]] Sample sample(std::span<const Coordinates<2>> x, std::size_t count) const override;

    [[nodiscard]] Cell_table<2>& table() override { return mirror_.table(); }
    [[nodiscard]] const Cell_table<2>& table() const { return mirror_.table(); }
    [[nodiscard]] std::size_t vertices() const override { return tr_.number_of_vertices(); }
    [[nodiscard]] int dimension() const override { return tr_.dimension(); }
    [[nodiscard]] bool delaunay_of(std::span<const Coordinates<2>> x, std::span<const Index> vertices,
                                   std::vector<std::array<Index, 3>>& cells) override;
    void follow(std::span<const Index> cells) override { mirror_.follow(cells, handle_); }
    void restore_cells(std::span<const Index> cells, std::vector<Index>& made) override { mirror_.restore(cells, made); }
    [[nodiscard]] bool reinsert(Index v, const Coordinates<2>& p, std::vector<Index>& changed) override;
    void set_point(Index v, const Coordinates<2>& p) override { handle_[at(v)]->set_point(point(p)); }
    void set_points(std::span<const Coordinates<2>> x) override;
    void rebuild(std::span<const Coordinates<2>> x) override;
    /// The same after a call that failed half way: x has a position for every index there is to be, `fresh` (or `none`) is one
    /// that the call inserted.
    void restore(std::span<const Coordinates<2>> x, Index fresh);
    /// No cells, until a rebuild.
    void clear_cells() noexcept;
    /// Seconds the last rebuild spent on keeping handles valid.
    [[nodiscard]] double handle_seconds() const { return handle_seconds_; }

    /// Inserts p as vertex v (a new index, or a vacant one). False, with nothing changed, when a vertex is there.
    [[nodiscard]] bool insert(Index v, const Coordinates<2>& p, std::vector<Index>& changed);
    /// Removes v; its index becomes vacant and its handle invalid.
    void remove(Index v, std::vector<Index>& changed);

    /// The paper's baseline: locate, insert, remove, with v's handle kept.
    [[nodiscard]] Relocation relocate(Index v, const Coordinates<2>& p) {
        return cgal_2::relocate(tr_, handle_[at(v)], point(p));
    }
    /// Section 3.1 of the paper, as CGAL does it: flips when no incident triangle inverts, else relocation.
    [[nodiscard]] Relocation relocate_by_flips(Index v, const Coordinates<2>& p) {
        return cgal_2::relocate_by_flips(tr_, handle_[at(v)], point(p));
    }
    /// Writes v's point when no topological change is needed. False, with nothing changed, when one is.
    [[nodiscard]] bool update_in_place(Index v, const Coordinates<2>& p) {
        return cgal_2::update_in_place(tr_, handle_[at(v)], point(p));
    }

    /// Least tolerance of the certificates of v at CGAL's points, certified. Precondition: dimension 2.
    [[nodiscard]] double star_tolerance(Index v) const { return cgal_2::star_tolerance(tr_, handle_[at(v)]); }
    /// Least theta of the finite bi-cells that contain v, at CGAL's points; pi/2 when there is none.
    [[nodiscard]] double theta(Index v) const { return cgal_2::star_theta(tr_, handle_[at(v)]); }
    /// Calls visit(vertices) for each finite cell; edges (padded with `none`) when all points are collinear.
    template <class Visit>
    void for_each_finite_cell(Visit visit) const {
        cgal_2::for_each_finite_cell(tr_, visit);
    }

    /// Widths, tolerances and theta of everything, at CGAL's points. O(n).
    [[nodiscard]] Measures measure() const { return cgal_2::measure(tr_, handle_.size()); }

    /// Neighbour lists of every vertex, from CGAL's object.
    void neighbours(Neighbours_2& out) const { cgal_2::read_neighbours(tr_, handle_, out); }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] bool detach(Index v, std::vector<Index>& changed);
    [[nodiscard]] bool attach(Index v, const Coordinates<2>& p, Vertex_handle near, std::vector<Index>& changed);

    Triangulation tr_;
    Cgal_mirror_2<Triangulation> mirror_{tr_};
    std::vector<Vertex_handle> handle_;              // by vertex; default for a vacant index
    Insertion_order<Triangulation, 2> order_;
    bool mirrored_ = false;
    double handle_seconds_ = 0.0;
};

template <class Info>
void Cgal_embedding_2<Info>::build(std::span<const Coordinates<2>> x) {
    Triangulation tr;
    std::vector<Vertex_handle> handle(x.size());
    order_.forget();
    insert_in_order<2>(tr, x, order_.of(x, [](Index) { return true; }), [&](Vertex_handle v, Index i) {
        v->set_index(i);
        handle[at(i)] = v;
    });
    tr_.swap(tr);
    handle_ = std::move(handle);
    mirrored_ = false;
}

template <class Info>
void Cgal_embedding_2<Info>::mirror() {
    mirror_.build(handle_.size());
    mirrored_ = true;
}

template <class Info>
void Cgal_embedding_2<Info>::drop_mirror() noexcept {
    mirrored_ = false;
    mirror_.clear();
}

template <class Info>
Sample Cgal_embedding_2<Info>::sample(std::span<const Coordinates<2>> x, std::size_t count) const {
    Sample sample;
    if (tr_.dimension() != 2) return sample;
    const std::size_t stride = 1 + handle_.size() / (count + 1);
    for (std::size_t v = 0; v < handle_.size(); v += stride) {
        if (handle_[v] == Vertex_handle()) continue;
        const Face_handle c = handle_[v]->face();
        if (tr_.is_infinite(c)) continue;
        std::array<Index, 3> corner{};
        std::array<Index, 3> beyond{};
        for (int i = 0; i <= 2; ++i) {
            corner[static_cast<std::size_t>(i)] = c->vertex(i)->index();
            const Vertex_handle w = tr_.tds().mirror_vertex(c, i);
            beyond[static_cast<std::size_t>(i)] = tr_.is_infinite(w) ? infinite : w->index();
        }
        add_cell<2>(sample, x, corner, beyond);
    }
    return sample;
}

template <class Info>
void Cgal_embedding_2<Info>::set_points(std::span<const Coordinates<2>> x) {
    for (std::size_t i = 0; i < handle_.size(); ++i)
        if (handle_[i] != Vertex_handle()) handle_[i]->set_point(point(x[i]));
}

template <class Info>
bool Cgal_embedding_2<Info>::detach(Index v, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    if (tr_.dimension() != 2 || tr_.number_of_vertices() <= 3 || tr_.test_dim_down(handle)) return false;
    std::vector<Index> old_cells;
    std::vector<std::pair<Face_handle, int>> border;  // outside the star
    auto f = tr_.incident_faces(handle);
    const auto done = f;
    do {
        const Face_handle face = f;
        const int i = face->index(handle);
        old_cells.push_back(face->cell());
        border.emplace_back(face->neighbor(i), tr_.tds().mirror_index(face, i));
    } while (++f != done);
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    cgal_2::substitute(tr_, handle, stand_in);
    handle->set_face(Face_handle());
    tr_.remove(stand_in);
    // What lies inside the border now.
    std::vector<Face_handle> inside;
    Small_set<Face_handle, Handle_hash> met{Face_handle()};
    const auto enter = [&](Face_handle g) {
        if (met.insert(g)) inside.push_back(g);
    };
    for (const auto& [g, i] : border) met.insert(g);
    for (const auto& [g, i] : border) enter(g->neighbor(i));
    for (std::size_t k = 0; k < inside.size(); ++k)
        for (int i = 0; i <= 2; ++i) enter(inside[k]->neighbor(i));
    mirror_.table().set_absent(v);
    mirror_.replace(old_cells, inside, changed);
    return true;
}

template <class Info>
bool Cgal_embedding_2<Info>::reinsert(Index v, const Coordinates<2>& p, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    const Coordinates<2> home = coordinates(handle->point());
    Vertex_handle near;
    for (int i = 0; i <= 2; ++i)
        if (const Vertex_handle w = handle->face()->vertex(i); w != handle && !tr_.is_infinite(w)) near = w;
    if (!detach(v, changed)) return false;
    if (attach(v, p, near, changed)) return true;
    (void)attach(v, home, near, changed);
    throw Error(Error_code::collision, "another vertex is at that position");
}

template <class Info>
bool Cgal_embedding_2<Info>::attach(Index v, const Coordinates<2>& p, Vertex_handle near, std::vector<Index>& changed) {
    typename Triangulation::Locate_type type{};
    int i = 0;
    const Face_handle face = tr_.locate(point(p), type, i, near->face());
    if (type == Triangulation::VERTEX) return false;
    const Vertex_handle inserted = tr_.insert(point(p), type, face, i);
    const Vertex_handle handle = handle_[at(v)];
    cgal_2::substitute(tr_, inserted, handle);
    handle->set_point(point(p));
    tr_.tds().delete_vertex(inserted);
    mirror_.adopt_star(handle, changed);
    return true;
}

template <class Info>
bool Cgal_embedding_2<Info>::delaunay_of(std::span<const Coordinates<2>> x, std::span<const Index> vertices,
                                         std::vector<std::array<Index, 3>>& cells) {
    Delaunay_2<No_info> tr;
    typename Delaunay_2<No_info>::Vertex_handle last;
    for (const Index i : vertices) {
        const auto hint = last == typename Delaunay_2<No_info>::Vertex_handle() ? typename Delaunay_2<No_info>::Face_handle()
                                                                                : last->face();
        last = tr.insert(point(x[at(i)]), hint);
        last->set_index(i);
    }
    if (tr.dimension() != 2 || tr.number_of_vertices() != vertices.size()) return false;
    for (auto f = tr.all_faces_begin(); f != tr.all_faces_end(); ++f) {
        std::array<Index, 3> v{};
        for (int i = 0; i <= 2; ++i)
            v[static_cast<std::size_t>(i)] = tr.is_infinite(f->vertex(i)) ? infinite : f->vertex(i)->index();
        cells.push_back(v);
    }
    return true;
}

template <class Info>
bool Cgal_embedding_2<Info>::insert(Index v, const Coordinates<2>& p, std::vector<Index>& changed) {
    typename Triangulation::Locate_type type{};
    int i = 0;
    const Face_handle face = tr_.locate(point(p), type, i);
    if (type == Triangulation::VERTEX) return false;
    order_.forget();
    const int before = tr_.dimension();
    const Vertex_handle inserted = tr_.insert(point(p), type, face, i);
    inserted->set_index(v);
    if (at(v) >= handle_.size()) handle_.resize(at(v) + 1);
    handle_[at(v)] = inserted;
    if (!mirrored_) return true;
    if (before == 2) {
        mirror_.table().set_vertex_bound(handle_.size());
        mirror_.adopt_star(inserted, changed);
    } else {
        mirror();
    }
    return true;
}

template <class Info>
void Cgal_embedding_2<Info>::remove(Index v, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    order_.forget();
    if (mirrored_ && detach(v, changed)) {
        tr_.tds().delete_vertex(handle);
        handle_[at(v)] = Vertex_handle();
        return;
    }
    tr_.remove(handle);
    handle_[at(v)] = Vertex_handle();
    if (mirrored_) mirror();
}

template <class Info>
void Cgal_embedding_2<Info>::restore(std::span<const Coordinates<2>> x, Index fresh) {
    if (fresh != none && at(fresh) < handle_.size()) handle_[at(fresh)] = Vertex_handle();
    handle_.resize(x.size());
    order_.forget();
    auto& vertices = tr_.tds().vertices();
    for (auto it = vertices.begin(); it != vertices.end();) {
        const Vertex_handle v = it++;
        const bool ours = v->index() != none && at(v->index()) < handle_.size() && handle_[at(v->index())] == v;
        if (!ours && v != tr_.infinite_vertex()) tr_.tds().delete_vertex(v);
    }
    rebuild(x);
}

template <class Info>
void Cgal_embedding_2<Info>::clear_cells() noexcept {
    tr_.tds().faces().clear();
    tr_.tds().set_dimension(-1);
    mirror_.clear();
}

template <class Info>
void Cgal_embedding_2<Info>::rebuild(std::span<const Coordinates<2>> x) {
    Triangulation other;
    const auto order = order_.of(x, [this](Index i) { return handle_[at(i)] != Vertex_handle(); });
    insert_in_order<2>(other, x, order, [](Vertex_handle v, Index i) { v->set_index(i); });
    const auto start = std::chrono::steady_clock::now();
    cgal_2::take_faces<Triangulation>(tr_, other, handle_);
    if (mirrored_) mirror();
    handle_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace annulus
