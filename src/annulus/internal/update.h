// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_view: how it is brought up to date.
#include <annulus/internal/view.h>

#include <algorithm>
#include <new>
#include <utility>

namespace annulus::inline v1 {

template <class Traits>
Cgal_view<Traits>::Cgal_view(Mesh_access<d> mesh, std::span<const Coordinates<d>> x) : mesh_(mesh) {
    handle_.resize(x.size());
    create_vertices([this](Index) { return tr_.tds().create_vertex(); });
    mesh_.set_dirty_cells(dirty_cells_);
}

template <class Traits>
template <class Original>
Cgal_view<Traits>::Cgal_view(Mesh_access<d> mesh, std::span<const Coordinates<d>> x, Original original) : mesh_(mesh) {
    handle_.resize(x.size());
    create_vertices([&](Index v) {
        const Vertex& copied = *original(v);
        return tr_.tds().create_vertex(copied);
    });
    mesh_.set_dirty_cells(dirty_cells_);
}

/// In the order of cells, which is a spatial one, so that vertices near each other are near in memory.
template <class Traits>
template <class Create>
void Cgal_view<Traits>::create_vertices(Create create) {
    numbers_.add(tr_.infinite_vertex());
    numbers_.set(tr_.infinite_vertex(), infinite);
    const auto create_one = [&](Index v) {
        if (v < 0 || handle_[at(v)] != Vertex_handle() || !mesh_.has(v)) return;
        handle_[at(v)] = create(v);
        numbers_.add(handle_[at(v)]);
        numbers_.set(handle_[at(v)], v);
    };
    const Table_cells<d> t = mesh_.cells();
    for (const Cell_index c : t.cells())
        for (const Index v : t.vertices(c)) create_one(v);
    for (std::size_t v = 0; v < handle_.size(); ++v) create_one(static_cast<Index>(v));
}

template <class Traits>
void Cgal_view<Traits>::reserve_vertex() {
    if (handle_.size() == handle_.capacity()) handle_.reserve(2 * handle_.size() + 1);
    spare_ = tr_.tds().create_vertex();
    try {
        numbers_.add(spare_);
    } catch (...) {
        tr_.tds().delete_vertex(std::exchange(spare_, Vertex_handle()));
        throw;
    }
}

template <class Traits>
void Cgal_view<Traits>::drop_reserved() noexcept {
    numbers_.forget(spare_);
    tr_.tds().delete_vertex(std::exchange(spare_, Vertex_handle()));
}

template <class Traits>
auto Cgal_view<Traits>::adopt(Index v, const Coordinates<d>& p) noexcept -> Vertex_handle {
    if (at(v) >= handle_.size()) handle_.resize(at(v) + 1);
    numbers_.set(spare_, v);
    spare_->set_point(point(p));
    return handle_[at(v)] = std::exchange(spare_, Vertex_handle());
}

template <class Traits>
void Cgal_view<Traits>::forget(Index v) noexcept {
    numbers_.forget(handle_[at(v)]);
    tr_.tds().delete_vertex(std::exchange(handle_[at(v)], Vertex_handle()));
}

template <class Traits>
void Cgal_view<Traits>::invalidate(Index v) noexcept {
    constexpr std::size_t share = 16;
    state_.current = false;
    if (state_.moved.all) return;
    if (share * state_.moved.vertices.size() > handle_.size()) return invalidate();
    try {
        state_.moved.vertices.push_back(v);
    } catch (const std::bad_alloc&) {
        invalidate();
    }
}

template <class Traits>
auto Cgal_view<Traits>::update(std::span<const Coordinates<d>> x) const -> const Triangulation& {
    if (state_.current.load(std::memory_order_acquire)) return tr_;
    const std::lock_guard lock(state_.updating);
    if (state_.current.load(std::memory_order_relaxed)) return tr_;
    try {
        update_cells(x);
    } catch (...) {
        dirty_cells_.record_all();
        throw;
    }
    dirty_cells_.clear();
    update_points(x);
    state_.moved.vertices.clear();
    state_.moved.all = false;
    state_.current.store(true, std::memory_order_release);
    return tr_;
}

template <class Traits>
void Cgal_view<Traits>::update_cells(std::span<const Coordinates<d>> x) const {
    if (mesh_.dimension() < 0 && mesh_.vertices() > 0) remove_cells();  // there was no memory for cells
    else if (mesh_.dimension() < d) write_flat_cells(x);
    else if (dirty_cells_.everything() || tr_.dimension() != d) write_all_cells();
    else write_cells(dirty_cells_.cells());
}

template <class Traits>
void Cgal_view<Traits>::update_points(std::span<const Coordinates<d>> x) const {
    const auto show = [&](std::size_t v) {
        if (v < handle_.size() && handle_[v] != Vertex_handle()) handle_[v]->set_point(point(x[v]));
    };
    if (state_.moved.all)
        for (std::size_t v = 0; v < handle_.size(); ++v) show(v);
    else
        for (const Index v : state_.moved.vertices) show(at(v));
}

/// Writes the vertices and neighbours of a cell. Precondition: each neighbour has a CGAL cell.
template <class Traits>
void Cgal_view<Traits>::write_cell(const Table_cells<d>& t, Cell_index c) const {
    const Cell_handle cell = cell_[c];
    if constexpr (Has_number<Cell>) cell->set_cell(c.value());
    else *cell = Cell();
    for (int i = 0; i <= d; ++i) {
        const Corner_index twin = t.twin(t.corner(c, i));
        const Vertex_handle v = vertex_of(t.vertex(t.corner(c, i)));
        const Cell_handle beyond = cell_[t.cell_of(twin)];
        cell->set_vertex(i, v);
        cell->set_neighbor(i, beyond);
        beyond->set_neighbor(t.slot_of(twin), cell);
        Traits::set_cell_of(v, cell);
    }
}

template <class Traits>
void Cgal_view<Traits>::write_cells(std::span<const Cell_index> cells) const {
    const Table_cells<d> t = mesh_.cells();
    auto& tds = tr_.tds();
    grow(cell_, t.cell_bound().offset());
    std::vector<Cell_handle> left;
    for (const Cell_index c : cells)
        if (c < t.cell_bound() && !t.is_cell(c) && cell_[c] != Cell_handle())
            left.push_back(std::exchange(cell_[c], Cell_handle()));
    for (const Cell_index c : cells) {
        if (!(c < t.cell_bound()) || !t.is_cell(c) || cell_[c] != Cell_handle()) continue;
        if (left.empty()) {
            cell_[c] = Traits::create_cell(tds);
        } else {
            cell_[c] = left.back();
            left.pop_back();
        }
    }
    for (const Cell_handle c : left) Traits::delete_cell(tds, c);
    for (const Cell_index c : cells)
        if (c < t.cell_bound() && t.is_cell(c)) write_cell(t, c);
}

/// Overwrites the existing CGAL cells, in their order in memory.
template <class Traits>
void Cgal_view<Traits>::write_all_cells() const {
    const Table_cells<d> t = mesh_.cells();
    auto& tds = tr_.tds();
    auto& there = Traits::cells(tds);
    const std::size_t bound = t.cell_bound().offset();
    cell_.reserve(bound + bound / 32);  // so that write_cells() seldom reallocates
    cell_.assign(bound, Cell_handle());
    auto next = there.begin();
    for (const Cell_index c : t.cells())
        if (next != there.end()) cell_[c] = next++;
        else break;
    std::vector<Cell_handle> left;
    for (; next != there.end(); ++next) left.push_back(next);
    for (const Cell_handle c : left) Traits::delete_cell(tds, c);
    for (const Cell_index c : t.cells())
        if (cell_[c] == Cell_handle()) cell_[c] = Traits::create_cell(tds);
    tds.set_dimension(d);
    for (const Cell_index c : t.cells()) write_cell(t, c);
}

template <class Traits>
void Cgal_view<Traits>::remove_cells() const noexcept {
    Traits::cells(tr_.tds()).clear();
    tr_.tds().set_dimension(-1);
    cell_.clear();
}

/// For points in a hyperplane, CGAL's cells have one corner less, or two.
template <class Traits>
void Cgal_view<Traits>::write_flat_cells(std::span<const Coordinates<d>> x) const {
    const Flat_cells flat = mesh_.flat_cells(x);
    if (flat.dimension < 1) return write_vertices();
    remove_cells();
    auto& tds = tr_.tds();
    std::vector<Cell_handle> made(flat.vertices.size());
    for (Cell_handle& c : made) c = Traits::create_cell(tds);
    const std::size_t corners = flat.dimension == 1 ? 2 : 3;
    for (std::size_t k = 0; k < made.size(); ++k)
        for (std::size_t corner = 0; corner < corners; ++corner) {
            const auto i = static_cast<int>(corner);
            const Vertex_handle v = vertex_of(flat.vertices[k][corner]);
            made[k]->set_vertex(i, v);
            made[k]->set_neighbor(i, made[at(flat.neighbours[k][corner])]);
            Traits::set_cell_of(v, made[k]);
        }
    tds.set_dimension(flat.dimension);
}

/// For at most one vertex: the cells that CGAL has for it.
template <class Traits>
void Cgal_view<Traits>::write_vertices() const {
    const auto one = std::find_if(handle_.begin(), handle_.end(), [](Vertex_handle v) { return v != Vertex_handle(); });
    Triangulation other;
    if (one != handle_.end()) other.insert((*one)->point());
    remove_cells();
    auto& tds = tr_.tds();
    auto& cells = Traits::cells(tds);
    cells.swap(Traits::cells(other.tds()));
    tds.set_dimension(other.dimension());
    for (auto c = cells.begin(); c != cells.end(); ++c) {
        const Vertex_handle v = c->vertex(0) == other.infinite_vertex() ? tr_.infinite_vertex() : *one;
        c->set_vertex(0, v);
        Traits::set_cell_of(v, c);
    }
    other.tds().set_dimension(-2);
}

}  // namespace annulus::inline v1
