// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding: one vertex inserted, removed or moved, with CGAL.
#include <annulus/cgal/embedding.h>

namespace annulus {

/// Not CGAL's `incident_cells`, which marks the cells and so is no reading for several threads. Precondition: dimension d.
template <class Traits>
auto Cgal_embedding<Traits>::star(Vertex_handle v) const -> std::vector<Cell_handle> {
    std::vector<Cell_handle> cells{Traits::cell_of(v)};
    Small_set<Cell_handle, Handle_hash> met{Cell_handle()};
    met.insert(cells[0]);
    for (std::size_t k = 0; k < cells.size(); ++k)
        for (int i = 0; i <= d; ++i) {
            const Cell_handle c = cells[k]->neighbor(i);
            if (cells[k]->vertex(i) != v && met.insert(c)) cells.push_back(c);
        }
    return cells;
}

/// Puts `replacement` in the place of `old` in every incident cell.
template <class Traits>
void Cgal_embedding<Traits>::substitute(Vertex_handle old, Vertex_handle replacement) {
    Traits::set_cell_of(replacement, Traits::cell_of(old));
    for (const Cell_handle c : star(old)) c->set_vertex(c->index(old), replacement);
}

/// v takes the place of `inserted`, which goes.
template <class Traits>
void Cgal_embedding<Traits>::exchange(Vertex_handle v, Vertex_handle inserted, const Coordinates<d>& p) {
    substitute(inserted, v);
    v->set_point(point(p));
    tr_.tds().delete_vertex(inserted);
}

template <class Traits>
bool Cgal_embedding<Traits>::detach(Index v, std::vector<Cell_index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    if (tr_.dimension() != d || tr_.number_of_vertices() <= d + 1U || Traits::rest_is_flat(tr_, handle, handle_)) return false;
    std::vector<Cell_index> old;
    for (const Cell_handle c : star(handle)) old.push_back(number_of(c));
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    Traits::set_cell_of(handle, Cell_handle());
    auto cells = take_out(stand_in);
    table_.set_absent(v);
    adopt(std::move(cells), std::move(old), changed);
    return true;
}

/// CGAL's removal of v. Precondition: dimension d. Returns the cells that fill its star, none when the rest is flat.
template <class Traits>
auto Cgal_embedding<Traits>::take_out(Vertex_handle v) -> std::vector<Cell_handle> {
    std::vector<std::pair<Cell_handle, int>> border;  // facets of cells that stay
    Small_set<Cell_handle, Handle_hash> met{Cell_handle()};
    for (const Cell_handle c : star(v)) {
        const int i = c->index(v);
        border.emplace_back(c->neighbor(i), Traits::slot_beyond(tr_.tds(), c, i));
        met.insert(c->neighbor(i));
    }
    shuffled_ = true;
    Traits::edit([&] { Traits::remove(tr_, v); });
    std::vector<Cell_handle> inside;
    if (tr_.dimension() != d) return inside;
    const auto enter = [&](Cell_handle c) {
        if (met.insert(c)) inside.push_back(c);
    };
    for (const auto& [c, i] : border) enter(c->neighbor(i));
    for (std::size_t k = 0; k < inside.size(); ++k)
        for (int i = 0; i <= d; ++i) enter(inside[k]->neighbor(i));
    return inside;
}

/// CGAL's triangulation to walk on, at positions x.
template <class Traits>
class Cgal_embedding<Traits>::Walker {
  public:
    Walker(const Triangulation& tr, std::span<const Coordinates<d>> x) : tr_(tr), x_(x) {}
    [[nodiscard]] bool is_infinite(Cell_handle c) const { return tr_.is_infinite(c); }
    [[nodiscard]] static Cell_handle beyond(Cell_handle c, int i) { return c->neighbor(i); }
    [[nodiscard]] Cell_handle inner(Cell_handle c) const { return c->neighbor(c->index(tr_.infinite_vertex())); }
    [[nodiscard]] Tuple<d, d + 1> corners(Cell_handle c) const { return tuple<d, d + 1>(points_of(tr_, c), x_); }

  private:
    const Triangulation& tr_;
    std::span<const Coordinates<d>> x_;
};

/// Where p is; own, or none, is a vertex that may be near. CGAL's walk begins where ours ends, and says on what p is.
template <class Traits>
auto Cgal_embedding<Traits>::locate(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Index own) ->
    typename Traits::Place {
    if (tr_.dimension() != d) return Traits::locate(tr_, point(p), Cell_handle());
    const auto lives = [this](Index v) { return has(v) && Traits::cell_of(handle_[at(v)]) != Cell_handle(); };
    const Index near = landmarks_.near(home, handle_.size(), p, own, lives);
    std::size_t steps = 0;
    const Cell_handle c = walk_to<d>(
        Walker(tr_, home), p, Traits::cell_of(near != none ? handle_[at(near)] : tr_.infinite_vertex()), steps);
    landmarks_.note(Landmarks<d>::nearest(home, points_of(tr_, c), p, own), steps);
    return Traits::locate(tr_, point(p), c);
}

template <class Traits>
bool Cgal_embedding<Traits>::attach(std::span<const Coordinates<d>> home, Index v, const Coordinates<d>& p, Index near,
                                    std::vector<Cell_index>& changed) {
    const auto place = locate(home, p, near);
    if (place.is_vertex()) return false;
    Vertex_handle inserted;
    Traits::edit([&] { inserted = Traits::insert(tr_, point(p), place); });
    exchange(handle_[at(v)], inserted, p);
    auto cells = star(handle_[at(v)]);
    std::vector<Cell_index> old;
    for (const Cell_handle c : cells)
        if (number_of(c) != no_cell) old.push_back(number_of(c));
    adopt(std::move(cells), std::move(old), changed);
    return true;
}

template <class Traits>
bool Cgal_embedding<Traits>::reinsert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p,
                                      std::vector<Cell_index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    Index near = none;
    for (int i = 0; i <= d; ++i)
        if (const Vertex_handle w = Traits::cell_of(handle)->vertex(i); w != handle && !tr_.is_infinite(w))
            near = w->index();
    if (!detach(v, changed)) return false;
    if (attach(home, v, p, near, changed)) {
        home[at(v)] = p;
        return true;
    }
    (void)attach(home, v, home[at(v)], near, changed);
    throw Error(Error_code::collision, "another vertex is at that position");
}

template <class Traits>
bool Cgal_embedding<Traits>::insert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p,
                                    std::vector<Cell_index>& changed) {
    const auto place = locate(home, p, none);
    if (place.is_vertex()) return false;
    order_.note_coming(v);
    const int before = tr_.dimension();
    Vertex_handle inserted;
    Traits::edit([&] { inserted = Traits::insert(tr_, point(p), place); });
    inserted->set_index(v);
    if (at(v) >= handle_.size()) handle_.resize(at(v) + 1);
    handle_[at(v)] = inserted;
    home[at(v)] = p;
    if (!mirrored_) return true;
    if (before == d) {
        table_.set_vertex_bound(handle_.size());
        auto cells = star(inserted);
        std::vector<Cell_index> old;
        for (const Cell_handle c : cells)
            if (number_of(c) != no_cell) old.push_back(number_of(c));
        adopt(std::move(cells), std::move(old), changed);
    } else {
        mirror();
    }
    return true;
}

template <class Traits>
void Cgal_embedding<Traits>::remove(std::span<const Coordinates<d>>, Index v, std::vector<Cell_index>& changed) {
    const Vertex_handle handle = handle_[at(v)];
    order_.note_going(v);
    if (mirrored_ && detach(v, changed)) {
        tr_.tds().delete_vertex(handle);
        handle_[at(v)] = Vertex_handle();
        return;
    }
    if (tr_.dimension() == d) {
        auto cells = take_out(handle);
        put_in_order(cells);
    } else {
        shuffled_ = true;
        Traits::edit([&] { Traits::remove(tr_, handle); });
    }
    handle_[at(v)] = Vertex_handle();
    if (mirrored_) mirror();
}

/// All anew: CGAL's vertices of lower dimensions are few ways to get wrong.
template <class Traits>
Relocation Cgal_embedding<Traits>::relocate_flat(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) {
    std::vector<Coordinates<d>> x(home.begin(), home.end());
    x[at(v)] = p;
    rebuild(x);
    home[at(v)] = p;
    return Relocation::reinserted;
}

template <class Traits>
Relocation Cgal_embedding<Traits>::relocate(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) {
    const Vertex_handle handle = handle_[at(v)];
    const auto place = locate(home, p, v);
    if (place.is_vertex()) return place.vertex() == handle ? Relocation::kept : Relocation::refused;
    if (tr_.dimension() != d) return relocate_flat(home, v, p);
    Vertex_handle inserted;
    Traits::edit([&] { inserted = Traits::insert(tr_, point(p), place); });
    // The handle moves to the new star and the newcomer to the old one, where it is removed.
    const Vertex_handle stand_in = tr_.tds().create_vertex();
    stand_in->set_point(handle->point());
    substitute(handle, stand_in);
    exchange(handle, inserted, p);
    auto cells = take_out(stand_in);
    put_in_order(cells);
    home[at(v)] = p;
    return Relocation::reinserted;
}

/// CGAL does not tell whether it flipped, so its first question is asked beforehand.
template <class Traits>
Relocation Cgal_embedding<Traits>::relocate_by_flips(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) {
    if constexpr (d == 2) {
        const Vertex_handle handle = handle_[at(v)];
        bool flips = false;
        if (tr_.dimension() == 2) {
            const Point old = handle->point();
            handle->set_point(point(p));
            flips = tr_.well_oriented(handle);
            handle->set_point(old);
        }
        if (tr_.move_if_no_collision(handle, point(p)) != handle) return Relocation::refused;
        home[at(v)] = p;
        return flips ? Relocation::flipped : Relocation::reinserted;
    } else {
        if (!update_in_place(v, p)) return relocate(home, v, p);
        home[at(v)] = p;
        return Relocation::kept;
    }
}

template <class Traits>
bool Cgal_embedding<Traits>::update_in_place(Index v, const Coordinates<d>& p) {
    if (tr_.dimension() != d) return false;
    const Vertex_handle handle = handle_[at(v)];
    const Point old = handle->point();
    handle->set_point(point(p));
    bool holds = true;
    const auto cells = star(handle);
    for (const Cell_handle c : cells) holds = holds && verdict_of_cell(c).sign > 0;
    if (holds)
        for_each_facet_around(handle, [&](Cell_handle c, int i) {
            if (!holds) return;
            const Certificate f = certificate(c, i);
            holds = facet_verdict(f.kind, f.x).sign > 0;
        });
    if (!holds) handle->set_point(old);
    return holds;
}

}  // namespace annulus
