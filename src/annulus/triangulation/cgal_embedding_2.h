// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/error.h>
#include <annulus/certificate/ladder.h>
#include <annulus/certificate/theta.h>
#include <annulus/triangulation/cgal_types_2.h>
#include <annulus/triangulation/embedding.h>
#include <annulus/triangulation/measures.h>
#include <annulus/triangulation/neighbours.h>

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

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
    void mirror();
    /// Forgets the mirror: the strategies that do not use it work on CGAL's object alone.
    void drop_mirror() { mirrored_ = false; }
    [[nodiscard]] bool mirrored() const { return mirrored_; }

    [[nodiscard]] Cell_table<2>& table() override { return table_; }
    [[nodiscard]] const Cell_table<2>& table() const { return table_; }
    [[nodiscard]] std::size_t vertices() const override { return tr_.number_of_vertices(); }
    [[nodiscard]] int dimension() const override { return tr_.dimension(); }
    void flip(Index h) override;
    [[nodiscard]] bool detach(Index v, std::vector<Index>& changed) override;
    [[nodiscard]] bool attach(Index v, const Coordinates<2>& p, std::vector<Index>& changed) override;
    void set_point(Index v, const Coordinates<2>& p) override { handle_[at(v)]->set_point(point(p)); }
    void set_points(std::span<const Coordinates<2>> x) override;
    void rebuild(std::span<const Coordinates<2>> x) override;
    /// Seconds the last rebuild spent on keeping handles valid.
    [[nodiscard]] double handle_seconds() const { return handle_seconds_; }

    /// Inserts p as vertex v (a new index, or a vacant one). False, with nothing changed, when a vertex is there.
    [[nodiscard]] bool insert(Index v, const Coordinates<2>& p, std::vector<Index>& changed);
    /// Removes v; its index becomes vacant and its handle invalid.
    void remove(Index v, std::vector<Index>& changed);

    /// The paper's baseline: locate, insert, remove, with v's handle kept. False when another vertex is at p.
    [[nodiscard]] bool relocate(Index v, const Coordinates<2>& p);
    /// Section 3.1 of the paper, as CGAL does it: flips when no incident triangle inverts, else relocation.
    [[nodiscard]] bool relocate_by_flips(Index v, const Coordinates<2>& p);
    /// Writes v's point when no topological change is needed. False, with nothing changed, when one is.
    [[nodiscard]] bool update_in_place(Index v, const Coordinates<2>& p);

    /// Least tolerance of the certificates of v at CGAL's points, certified. Precondition: dimension 2.
    [[nodiscard]] double star_tolerance(Index v) const;
    /// Least theta of the finite bi-cells that contain v, at CGAL's points; pi/2 when there is none.
    [[nodiscard]] double theta(Index v) const;
    /// Calls visit(vertices) for each finite cell; edges (padded with `none`) when all points are collinear.
    template <class Visit>
    void for_each_finite_cell(Visit visit) const;

    /// Widths, tolerances and theta of everything, at CGAL's points. O(n).
    [[nodiscard]] Measures measure() const;

    /// Neighbour lists of every vertex, from CGAL's object.
    void neighbours(Neighbours_2& out) const;

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    using Plain = CGAL::Delaunay_triangulation_2<
        Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>,
                                                     Indexed_face_base_2<Kernel>>>;

    [[nodiscard]] static Index index_of(const Triangulation& tr, Vertex_handle v) {
        return tr.is_infinite(v) ? infinite : v->index();
    }
    void substitute(Vertex_handle old, Vertex_handle replacement);
    void replace_cells(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces,
                       std::vector<Index>& changed);
    void adopt_star(Vertex_handle v, std::vector<Index>& changed);
    void transplant(Plain& other);
    [[nodiscard]] bool star_holds(Vertex_handle v) const;
    [[nodiscard]] Verdict edge_verdict(Face_handle f, int i) const;
    [[nodiscard]] Verdict face_verdict(Face_handle f) const;
    template <class Visit>
    void for_each_edge_around(Vertex_handle v, Visit visit) const;
    template <class T, class Assign>
    static void insert_sorted(T& tr, std::span<const Coordinates<2>> x, std::span<const char> live, Assign assign);

    Triangulation tr_;
    Cell_table<2> table_;
    std::vector<Face_handle> face_;      // by cell
    std::vector<Vertex_handle> handle_;  // by vertex; default for a vacant index
    std::vector<std::pair<Index, Index>> detached_;  // vertex and a neighbour it had
    bool mirrored_ = false;
    double handle_seconds_ = 0.0;
};

template <class Info>
template <class T, class Assign>
void Cgal_embedding_2<Info>::insert_sorted(T& tr, std::span<const Coordinates<2>> x, std::span<const char> live,
                                           Assign assign) {
    // CGAL's insert of a range of points with info does just this; here the assigner learns of duplicates.
    std::vector<Point> points;
    std::vector<std::size_t> order;
    points.reserve(x.size());
    order.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        points.push_back(live.empty() || live[i] ? point(x[i]) : Point(0, 0));
        if (live.empty() || live[i]) order.push_back(i);
    }
    using Map = typename CGAL::Pointer_property_map<Point>::type;
    const CGAL::Spatial_sort_traits_adapter_2<Kernel, Map> traits(CGAL::make_property_map(points));
    CGAL::spatial_sort(order.begin(), order.end(), traits);
    typename T::Face_handle hint;
    std::size_t count = 0;
    for (const std::size_t i : order) {
        const auto v = tr.insert(points[i], hint);
        if (tr.number_of_vertices() == count)
            throw Error(Error_code::collision, "point " + std::to_string(i) + " has the position of another point");
        ++count;
        assign(v, static_cast<Index>(i));
        hint = v->face();
    }
}

template <class Info>
void Cgal_embedding_2<Info>::build(std::span<const Coordinates<2>> x) {
    Triangulation tr;
    std::vector<Vertex_handle> handle(x.size());
    insert_sorted(tr, x, {}, [&](Vertex_handle v, Index i) {
        v->set_index(i);
        handle[at(i)] = v;
    });
    tr_.swap(tr);
    handle_ = std::move(handle);
    mirrored_ = false;
}

template <class Info>
void Cgal_embedding_2<Info>::mirror() {
    table_.clear(handle_.size());
    face_.clear();
    mirrored_ = true;
    if (tr_.dimension() != 2) return;
    std::vector<Face_handle> faces;
    for (auto f = tr_.all_faces_begin(); f != tr_.all_faces_end(); ++f) {
        f->set_cell(none);
        faces.push_back(f);
    }
    // Cells and facets are numbered along the vertices, so that what is near in the plane is near in memory whenever
    // the caller's order is.
    const auto least = [this](Face_handle f) {
        return std::min({index_of(tr_, f->vertex(0)), index_of(tr_, f->vertex(1)), index_of(tr_, f->vertex(2))});
    };
    std::sort(faces.begin(), faces.end(), [&](Face_handle f, Face_handle g) { return least(f) < least(g); });
    std::vector<Index> changed;
    replace_cells({}, faces, changed);
}

template <class Info>
void Cgal_embedding_2<Info>::flip(Index h) {
    const Face_handle f = face_[at(table_.cell_of(h))];
    tr_.tds().flip(f, table_.slot_of(h));
    table_.flip(h);
}

template <class Info>
void Cgal_embedding_2<Info>::set_points(std::span<const Coordinates<2>> x) {
    for (std::size_t i = 0; i < handle_.size(); ++i)
        if (handle_[i] != Vertex_handle()) handle_[i]->set_point(point(x[i]));
}

/// Mirrors a changed region: old_cells have gone or changed, faces are what fills their place now (possibly the same
/// CGAL faces). Facets on the border of the region keep their index.
template <class Info>
void Cgal_embedding_2<Info>::replace_cells(const std::vector<Index>& old_cells, const std::vector<Face_handle>& faces,
                                           std::vector<Index>& changed) {
    const auto is_old = [&](Index c) { return std::find(old_cells.begin(), old_cells.end(), c) != old_cells.end(); };
    for (const Index c : old_cells)
        for (int i = 0; i <= 2; ++i) {
            const Index h = table_.corner(c, i);
            const Index t = table_.twin(h);
            if (h < t && is_old(table_.cell_of(t))) table_.free_facet(table_.facet(h));
        }
    std::vector<char> kept(old_cells.size(), 0);
    for (const Face_handle f : faces) {
        const auto it = f->cell() == none ? old_cells.end() : std::find(old_cells.begin(), old_cells.end(), f->cell());
        if (it != old_cells.end()) kept[static_cast<std::size_t>(it - old_cells.begin())] = 1;
    }
    for (std::size_t k = 0; k < old_cells.size(); ++k)
        if (!kept[k]) table_.free_cell(old_cells[k]);
    for (const Face_handle f : faces) {
        if (f->cell() == none) f->set_cell(table_.new_cell());
        const Index c = f->cell();
        if (at(c) >= face_.size()) face_.resize(at(c) + 1);
        face_[at(c)] = f;
        for (int i = 0; i <= 2; ++i) table_.set_vertex(table_.corner(c, i), index_of(tr_, f->vertex(i)));
        changed.push_back(c);
    }
    std::vector<Index> inside;
    if (!old_cells.empty()) {
        inside = changed;
        std::sort(inside.begin(), inside.end());
    }
    for (const Face_handle f : faces)
        for (int i = 0; i <= 2; ++i) {
            const Face_handle g = f->neighbor(i);
            const Index h = table_.corner(f->cell(), i);
            const Index t = table_.corner(g->cell(), tr_.tds().mirror_index(f, i));
            const bool interior =
                old_cells.empty() || std::binary_search(inside.begin(), inside.end(), g->cell());
            if (!interior) {
                table_.glue(h, t, table_.facet(t));
            } else if (h < t) {
                table_.glue(h, t);
            }
        }
}

/// Puts `replacement` in the place of `old` in every incident face.
template <class Info>
void Cgal_embedding_2<Info>::substitute(Vertex_handle old, Vertex_handle replacement) {
    std::vector<Face_handle> star;
    auto f = tr_.incident_faces(old);
    const auto done = f;
    do star.push_back(f);
    while (++f != done);
    replacement->set_face(old->face());
    for (const Face_handle g : star) g->set_vertex(g->index(old), replacement);
}

template <class Info>
bool Cgal_embedding_2<Info>::detach(Index v, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    if (tr_.dimension() != 2 || tr_.number_of_vertices() <= 3 || tr_.test_dim_down(handle)) return false;
    std::vector<Index> old_cells;
    std::vector<std::pair<Face_handle, int>> border;  // outside the star
    Index neighbour = none;
    auto f = tr_.incident_faces(handle);
    const auto done = f;
    do {
        const Face_handle face = f;
        const int i = face->index(handle);
        old_cells.push_back(face->cell());
        border.emplace_back(face->neighbor(i), tr_.tds().mirror_index(face, i));
        if (!tr_.is_infinite(face->vertex(tr_.ccw(i)))) neighbour = face->vertex(tr_.ccw(i))->index();
    } while (++f != done);
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    handle->set_face(Face_handle());
    tr_.remove(stand_in);
    // What lies inside the border now.
    std::vector<Face_handle> inside;
    const auto enter = [&](Face_handle g) {
        const bool outer = std::any_of(border.begin(), border.end(), [&](const auto& b) { return b.first == g; });
        if (!outer && std::find(inside.begin(), inside.end(), g) == inside.end()) inside.push_back(g);
    };
    for (const auto& [g, i] : border) {
        const Face_handle in = g->neighbor(i);
        if (std::find(inside.begin(), inside.end(), in) == inside.end()) inside.push_back(in);
    }
    for (std::size_t k = 0; k < inside.size(); ++k)
        for (int i = 0; i <= 2; ++i) enter(inside[k]->neighbor(i));
    table_.set_absent(v);
    replace_cells(old_cells, inside, changed);
    detached_.emplace_back(v, neighbour);
    return true;
}

template <class Info>
void Cgal_embedding_2<Info>::adopt_star(Vertex_handle v, std::vector<Index>& changed) {
    std::vector<Index> old_cells;
    std::vector<Face_handle> faces;
    auto f = tr_.incident_faces(v);
    const auto done = f;
    do {
        const Face_handle face = f;
        if (face->cell() != none) old_cells.push_back(face->cell());
        faces.push_back(face);
    } while (++f != done);
    replace_cells(old_cells, faces, changed);
}

template <class Info>
bool Cgal_embedding_2<Info>::attach(Index v, const Coordinates<2>& p, std::vector<Index>& changed) {
    Face_handle start;
    const auto it =
        std::find_if(detached_.begin(), detached_.end(), [v](const auto& entry) { return entry.first == v; });
    if (it != detached_.end()) {
        if (it->second != none && handle_[at(it->second)] != Vertex_handle()) start = handle_[at(it->second)]->face();
        detached_.erase(it);
    }
    typename Triangulation::Locate_type type{};
    int i = 0;
    const Face_handle face = tr_.locate(point(p), type, i, start);
    if (type == Triangulation::VERTEX) return false;
    const Vertex_handle inserted = tr_.insert(point(p), type, face, i);
    const Vertex_handle handle = handle_[at(v)];
    substitute(inserted, handle);
    handle->set_point(point(p));
    tr_.tds().delete_vertex(inserted);
    adopt_star(handle, changed);
    return true;
}

template <class Info>
bool Cgal_embedding_2<Info>::insert(Index v, const Coordinates<2>& p, std::vector<Index>& changed) {
    typename Triangulation::Locate_type type{};
    int i = 0;
    const Face_handle face = tr_.locate(point(p), type, i);
    if (type == Triangulation::VERTEX) return false;
    const int before = tr_.dimension();
    const Vertex_handle inserted = tr_.insert(point(p), type, face, i);
    inserted->set_index(v);
    if (at(v) >= handle_.size()) handle_.resize(at(v) + 1);
    handle_[at(v)] = inserted;
    if (!mirrored_) return true;
    if (before == 2) {
        table_.set_vertex_bound(handle_.size());
        adopt_star(inserted, changed);
    } else {
        mirror();
    }
    return true;
}

template <class Info>
void Cgal_embedding_2<Info>::remove(Index v, std::vector<Index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    if (mirrored_ && detach(v, changed)) {
        detached_.pop_back();
        tr_.tds().delete_vertex(handle);
        handle_[at(v)] = Vertex_handle();
        return;
    }
    tr_.remove(handle);
    handle_[at(v)] = Vertex_handle();
    if (mirrored_) mirror();
}

template <class Info>
void Cgal_embedding_2<Info>::rebuild(std::span<const Coordinates<2>> x) {
    std::vector<char> live;
    if (std::find(handle_.begin(), handle_.end(), Vertex_handle()) != handle_.end()) {
        live.resize(handle_.size());
        for (std::size_t i = 0; i < live.size(); ++i) live[i] = handle_[i] != Vertex_handle();
    }
    Plain other;
    insert_sorted(other, x, live, [](typename Plain::Vertex_handle v, Index i) { v->info() = i; });
    const auto start = std::chrono::steady_clock::now();
    transplant(other);
    detached_.clear();
    if (mirrored_) mirror();
    handle_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Gives our vertices, which callers hold handles of, the faces and points of another triangulation of the same set.
template <class Info>
void Cgal_embedding_2<Info>::transplant(Plain& other) {
    auto& tds = tr_.tds();
    tds.faces().clear();
    const int dim = other.dimension();
    tds.set_dimension(dim);
    const auto ours = [&](typename Plain::Vertex_handle v) {
        return other.is_infinite(v) ? tr_.infinite_vertex() : handle_[at(v->info())];
    };
    std::vector<Face_handle> face;
    std::vector<typename Plain::Face_handle> source;
    for (auto f = other.tds().faces().begin(); f != other.tds().faces().end(); ++f) {
        f->set_cell(static_cast<Index>(face.size()));
        source.push_back(f);
        face.push_back(tds.create_face());
    }
    for (std::size_t k = 0; k < face.size(); ++k)
        for (int i = 0; i <= std::max(dim, 0); ++i) {
            if (source[k]->vertex(i) != typename Plain::Vertex_handle())
                face[k]->set_vertex(i, ours(source[k]->vertex(i)));
            if (source[k]->neighbor(i) != typename Plain::Face_handle())
                face[k]->set_neighbor(i, face[at(source[k]->neighbor(i)->cell())]);
        }
    for (auto v = other.tds().vertices().begin(); v != other.tds().vertices().end(); ++v) {
        const typename Plain::Vertex_handle from = v;
        const Vertex_handle to = ours(from);
        to->set_face(from->face() == typename Plain::Face_handle() ? Face_handle() : face[at(from->face()->cell())]);
        if (!other.is_infinite(from)) to->set_point(from->point());
    }
}

template <class Info>
bool Cgal_embedding_2<Info>::relocate(Index v, const Coordinates<2>& p) {
    const Vertex_handle handle = handle_[at(v)];
    typename Triangulation::Locate_type type{};
    int i = 0;
    if (tr_.dimension() != 2) return relocate_by_flips(v, p);
    const Face_handle face = tr_.locate(point(p), type, i, handle->face());
    if (type == Triangulation::VERTEX) return face->vertex(i) == handle;
    const Vertex_handle inserted = tr_.insert(point(p), type, face, i);
    // The handle moves to the new star and the newcomer to the old one, where it is removed.
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    substitute(inserted, handle);
    handle->set_point(point(p));
    tr_.tds().delete_vertex(inserted);
    tr_.remove(stand_in);
    return true;
}

template <class Info>
bool Cgal_embedding_2<Info>::relocate_by_flips(Index v, const Coordinates<2>& p) {
    return tr_.move_if_no_collision(handle_[at(v)], point(p)) == handle_[at(v)];
}

/// Visits (face, i) for every edge whose bi-cell contains v: the spokes and the link.
template <class Info>
template <class Visit>
void Cgal_embedding_2<Info>::for_each_edge_around(Vertex_handle v, Visit visit) const {
    auto f = tr_.incident_faces(v);
    const auto done = f;
    do {
        const Face_handle face = f;
        const int i = face->index(v);
        visit(face, i);
        visit(face, tr_.ccw(i));
    } while (++f != done);
}

/// The verdict of the edge (f, i), with the perturbation deciding cocircular points; positive where it has no
/// certificate of its own.
template <class Info>
Verdict Cgal_embedding_2<Info>::edge_verdict(Face_handle f, int i) const {
    const auto x = [](Vertex_handle w) { return coordinates(w->point()); };
    const Face_handle g = f->neighbor(i);
    const Vertex_handle p = g->vertex(tr_.tds().mirror_index(f, i));
    const bool f_infinite = tr_.is_infinite(f);
    if (f_infinite != tr_.is_infinite(g)) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    const Vertex_handle va = f->vertex(tr_.ccw(i));
    const Vertex_handle vb = f->vertex(tr_.cw(i));
    const Coordinates<2> a = x(tr_.is_infinite(va) ? p : va);
    const Coordinates<2> b = x(tr_.is_infinite(vb) ? p : vb);
    const Coordinates<2> q = x(f->vertex(i));
    if (f_infinite) {  // infinity replaced by the vertex across: the hull is convex when this turns right or not at all
        Verdict out = orientation_verdict({&b, &a, &q});
        if (out.sign == 0) out.sign = 1;
        return out;
    }
    const Coordinates<2> px = x(p);
    const Tuple<2, 4> bicell{&a, &b, &px, &q};
    Verdict out = empty_sphere_verdict(bicell);
    if (out.sign == 0) out.sign = static_cast<std::int8_t>(perturbed_empty_circle_sign(bicell));
    return out;
}

template <class Info>
Verdict Cgal_embedding_2<Info>::face_verdict(Face_handle f) const {
    if (tr_.is_infinite(f)) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    const std::array<Coordinates<2>, 3> x{coordinates(f->vertex(0)->point()), coordinates(f->vertex(1)->point()),
                                          coordinates(f->vertex(2)->point())};
    return orientation_verdict({&x[0], &x[1], &x[2]});
}

/// Exact test of every certificate that contains v, at CGAL's points.
template <class Info>
bool Cgal_embedding_2<Info>::star_holds(Vertex_handle v) const {
    auto f = tr_.incident_faces(v);
    const auto done = f;
    do
        if (face_verdict(f).sign <= 0) return false;
    while (++f != done);
    bool holds = true;
    for_each_edge_around(v, [&](Face_handle face, int i) { holds = holds && edge_verdict(face, i).sign > 0; });
    return holds;
}

template <class Info>
double Cgal_embedding_2<Info>::star_tolerance(Index v) const {
    double least = std::numeric_limits<double>::infinity();
    auto f = tr_.incident_faces(handle_[at(v)]);
    const auto done = f;
    do least = std::min(least, face_verdict(f).tolerance);
    while (++f != done);
    for_each_edge_around(handle_[at(v)], [&](Face_handle face, int i) {
        least = std::min(least, edge_verdict(face, i).tolerance);
    });
    return least;
}

template <class Info>
double Cgal_embedding_2<Info>::theta(Index v) const {
    double least = 1.5707963267948966;  // pi / 2
    if (tr_.dimension() != 2) return least;
    for_each_edge_around(handle_[at(v)], [&](Face_handle f, int i) {
        if (tr_.is_infinite(f) || tr_.is_infinite(f->neighbor(i))) return;
        const auto x = [](Vertex_handle w) { return coordinates(w->point()); };
        least = std::min(least, annulus::theta(x(f->vertex(tr_.ccw(i))), x(f->vertex(tr_.cw(i))),
                                               x(tr_.tds().mirror_vertex(f, i)), x(f->vertex(i))));
    });
    return least;
}

template <class Info>
Measures Cgal_embedding_2<Info>::measure() const {
    Measures m;
    m.tolerance.assign(handle_.size(), std::numeric_limits<double>::infinity());
    if (tr_.dimension() != 2) return m;
    const auto lower = [&](Vertex_handle v, double tolerance) {
        if (tr_.is_infinite(v)) return;
        double& t = m.tolerance[at(v->index())];
        t = std::min(t, tolerance);
    };
    for (auto f = tr_.finite_faces_begin(); f != tr_.finite_faces_end(); ++f) {
        const double t = face_verdict(f).tolerance;
        for (int i = 0; i <= 2; ++i) lower(f->vertex(i), t);
    }
    for (auto e = tr_.all_edges_begin(); e != tr_.all_edges_end(); ++e) {
        const auto [f, i] = *e;
        const Vertex_handle across = tr_.tds().mirror_vertex(f, i);
        const Verdict v = edge_verdict(f, i);
        lower(f->vertex(i), v.tolerance);
        lower(across, v.tolerance);
        lower(f->vertex(tr_.ccw(i)), v.tolerance);
        lower(f->vertex(tr_.cw(i)), v.tolerance);
        if (tr_.is_infinite(f) || tr_.is_infinite(f->neighbor(i))) continue;
        m.annulus_width.push_back(2.0 * v.tolerance);
        m.theta_min = std::min(m.theta_min, annulus::theta(coordinates(f->vertex(tr_.ccw(i))->point()),
                                                           coordinates(f->vertex(tr_.cw(i))->point()),
                                                           coordinates(across->point()), coordinates(f->vertex(i)->point())));
    }
    return m;
}

template <class Info>
template <class Visit>
void Cgal_embedding_2<Info>::for_each_finite_cell(Visit visit) const {
    if (tr_.dimension() == 2) {
        for (auto f = tr_.finite_faces_begin(); f != tr_.finite_faces_end(); ++f)
            visit(std::array<Index, 3>{f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()});
    } else if (tr_.dimension() == 1) {
        for (auto e = tr_.finite_edges_begin(); e != tr_.finite_edges_end(); ++e)
            visit(std::array<Index, 3>{e->first->vertex(0)->index(), e->first->vertex(1)->index(), none});
    }
}

template <class Info>
bool Cgal_embedding_2<Info>::update_in_place(Index v, const Coordinates<2>& p) {
    if (tr_.dimension() != 2) return false;
    const Vertex_handle handle = handle_[at(v)];
    const Point old = handle->point();
    handle->set_point(point(p));
    if (star_holds(handle)) return true;
    handle->set_point(old);
    return false;
}

template <class Info>
void Cgal_embedding_2<Info>::neighbours(Neighbours_2& out) const {
    out.begin.assign(1, 0);
    out.vertex.clear();
    out.hull.clear();
    out.vertex.reserve(6 * handle_.size());
    std::vector<Index> ring;
    for (const Vertex_handle v : handle_) {
        bool hull = false;
        ring.clear();
        if (v != Vertex_handle() && tr_.dimension() == 2) {
            auto w = tr_.incident_vertices(v);
            const auto done = w;
            std::size_t start = 0;
            do {
                if (tr_.is_infinite(w)) {
                    hull = true;
                    start = ring.size();
                } else {
                    ring.push_back(w->index());
                }
            } while (++w != done);
            std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
        } else if (v != Vertex_handle() && tr_.dimension() == 1) {
            hull = true;
            auto w = tr_.incident_vertices(v);
            const auto done = w;
            do
                if (!tr_.is_infinite(w)) ring.push_back(w->index());
            while (++w != done);
        } else {
            hull = v != Vertex_handle();
        }
        out.vertex.insert(out.vertex.end(), ring.begin(), ring.end());
        out.begin.push_back(static_cast<Index>(out.vertex.size()));
        out.hull.push_back(hull ? 1 : 0);
    }
}

}  // namespace annulus
