// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding: building from nothing, and anew with the caller's handles kept.
#include <annulus/cgal/embedding.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <chrono>
#include <exception>

namespace annulus {

template <class Traits>
void Cgal_embedding<Traits>::insert_all(Triangulation& tr, std::span<const Coordinates<d>> x, std::span<const Index> order,
                                        std::vector<Vertex_handle>* handle) {
    // An error is thrown outside, where the thread's table is known to be sound.
    std::exception_ptr collision;
    Traits::edit([&] {
        try {
            insert_in_order<Traits>(tr, x, order, [&](Vertex_handle v, Index i) {
                v->set_index(i);
                if (handle != nullptr) (*handle)[at(i)] = v;
            });
        } catch (const Error&) {
            collision = std::current_exception();
        }
    });
    if (collision) std::rethrow_exception(collision);
}

template <class Traits>
void Cgal_embedding<Traits>::build(std::span<const Coordinates<d>> x) {
    Triangulation tr;
    std::vector<Vertex_handle> handle(x.size());
    order_.forget();
    insert_all(tr, x, order_.of(x, [](Index) { return true; }, this->threads_), &handle);
    tr_.swap(tr);
    tr_.infinite_vertex()->set_index(infinite);
    handle_ = std::move(handle);
    mirrored_ = shuffled_ = false;
}

template <class Traits>
void Cgal_embedding<Traits>::restore(std::span<const Coordinates<d>> x, Index fresh) {
    if (fresh != none && at(fresh) < handle_.size()) handle_[at(fresh)] = Vertex_handle();
    handle_.resize(x.size());
    order_.forget();
    auto& vertices = tr_.tds().vertices();
    for (auto it = vertices.begin(); it != vertices.end();) {
        const Vertex_handle v = it++;
        const bool ours = v->index() >= 0 && at(v->index()) < handle_.size() && handle_[at(v->index())] == v;
        if (!ours && v != tr_.infinite_vertex()) tr_.tds().delete_vertex(v);
    }
    rebuild(x);
}

template <class Traits>
void Cgal_embedding<Traits>::clear_cells() noexcept {
    Traits::cells(tr_.tds()).clear();
    tr_.tds().set_dimension(-1);
    table_.clear(0);
    cell_.clear();
}

template <class Traits>
void Cgal_embedding<Traits>::rebuild(std::span<const Coordinates<d>> x) {
    Triangulation other;
    const auto lives = [this](Index i) { return handle_[at(i)] != Vertex_handle(); };
    insert_all(other, x, order_.of(x, lives, this->threads_), nullptr);
    const auto start = std::chrono::steady_clock::now();
    take_cells(other);
    shuffled_ = false;
    if (mirrored_) mirror();
    handle_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Gives our vertices, which callers hold handles of, the cells and points of another triangulation of the same set.
template <class Traits>
void Cgal_embedding<Traits>::take_cells(Triangulation& other) noexcept {
    auto& tds = tr_.tds();
    auto& cells = Traits::cells(tds);
    cells.swap(Traits::cells(other.tds()));
    tds.set_dimension(other.dimension());
    const auto ours = [&](Vertex_handle v) {
        return v == other.infinite_vertex() ? tr_.infinite_vertex() : handle_[at(v->index())];
    };
    const int last = std::max(tds.dimension(), 0);
    for (auto c = cells.begin(); c != cells.end(); ++c)
        for (int i = 0; i <= last; ++i)
            if (c->vertex(i) != Vertex_handle()) c->set_vertex(i, ours(c->vertex(i)));
    for (auto v = other.tds().vertices().begin(); v != other.tds().vertices().end(); ++v) {
        const Vertex_handle to = ours(v);
        Traits::set_cell_of(to, Traits::cell_of(v));
        if (to != tr_.infinite_vertex()) to->set_point(v->point());
    }
    Traits::cells(other.tds()).clear();  // ours of before, whose vertices are not theirs
    other.tds().set_dimension(-2);
}

template <class Traits>
void Cgal_embedding<Traits>::show_points(std::span<const Coordinates<d>> x) {
    for_each_run(handle_.size(), std::size_t{1} << 14, this->threads_, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i)
            if (handle_[i] != Vertex_handle()) handle_[i]->set_point(point(x[i]));
    });
}

template <class Traits>
bool Cgal_embedding<Traits>::delaunay_of(std::span<const Coordinates<d>> x, std::span<const Index> vertices,
                                         std::vector<Points>& cells) {
    return cgal_delaunay_of<typename Traits::Plain>(x, vertices, cells);
}

}  // namespace annulus
