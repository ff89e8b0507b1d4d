// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding_3: building from nothing, and anew with the caller's handles kept.
#include <annulus/triangulation/cgal_embedding_3.h>

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <chrono>

namespace annulus {

template <class Info>
template <class T, class Assign>
void Cgal_embedding_3<Info>::insert_sorted(T& tr, std::span<const Coordinates<3>> x, std::span<const char> live,
                                           Assign assign) {
    // CGAL's insert of a range of points with info does just this; here the assigner learns of duplicates.
    std::vector<Point> points;
    std::vector<std::size_t> order;
    points.reserve(x.size());
    order.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        points.push_back(live.empty() || live[i] ? point(x[i]) : Point(0, 0, 0));
        if (live.empty() || live[i]) order.push_back(i);
    }
    using Map = typename CGAL::Pointer_property_map<Point>::type;
    const CGAL::Spatial_sort_traits_adapter_3<Kernel, Map> traits(CGAL::make_property_map(points));
    CGAL::spatial_sort(order.begin(), order.end(), traits);
    bool distinct = true;
    std::size_t last = 0;
    cgal_3::with_sound_table([&] {
        typename T::Vertex_handle hint;
        std::size_t count = 0;
        for (const std::size_t i : order) {
            const auto v = hint == typename T::Vertex_handle() ? tr.insert(points[i]) : tr.insert(points[i], hint);
            distinct = tr.number_of_vertices() != count;
            last = i;
            if (!distinct) return;
            ++count;
            assign(v, static_cast<Index>(i));
            hint = v;
        }
    });
    if (!distinct)
        throw Error(Error_code::collision, "point " + std::to_string(last) + " has the position of another point");
}

template <class Info>
void Cgal_embedding_3<Info>::build(std::span<const Coordinates<3>> x) {
    Triangulation tr;
    std::vector<Vertex_handle> handle(x.size());
    insert_sorted(tr, x, {}, [&](Vertex_handle v, Index i) {
        v->set_index(i);
        handle[at(i)] = v;
    });
    tr_.swap(tr);
    handle_ = std::move(handle);
    detached_.clear();
    mirrored_ = false;
}

template <class Info>
void Cgal_embedding_3<Info>::restore(std::span<const Coordinates<3>> x, Index fresh) {
    if (fresh != none && at(fresh) < handle_.size()) handle_[at(fresh)] = Vertex_handle();
    handle_.resize(x.size());
    auto& vertices = tr_.tds().vertices();
    for (auto it = vertices.begin(); it != vertices.end();) {
        const Vertex_handle v = it++;
        const bool ours = v->index() != none && at(v->index()) < handle_.size() && handle_[at(v->index())] == v;
        if (!ours && v != tr_.infinite_vertex()) tr_.tds().delete_vertex(v);
    }
    rebuild(x);
}

template <class Info>
void Cgal_embedding_3<Info>::clear_cells() noexcept {
    tr_.tds().cells().clear();
    tr_.tds().set_dimension(-1);
    table_.clear(0);
    cell_.clear();
}

template <class Info>
void Cgal_embedding_3<Info>::rebuild(std::span<const Coordinates<3>> x) {
    std::vector<char> live;
    if (std::find(handle_.begin(), handle_.end(), Vertex_handle()) != handle_.end()) {
        live.resize(handle_.size());
        for (std::size_t i = 0; i < live.size(); ++i) live[i] = handle_[i] != Vertex_handle();
    }
    Plain other;
    insert_sorted(other, x, live, [](typename Plain::Vertex_handle v, Index i) { v->set_index(i); });
    const auto start = std::chrono::steady_clock::now();
    transplant(other);
    detached_.clear();
    if (mirrored_) mirror();
    handle_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Gives our vertices, which callers hold handles of, the cells and points of another triangulation of the same set.
template <class Info>
void Cgal_embedding_3<Info>::transplant(Plain& other) {
    auto& tds = tr_.tds();
    tds.cells().clear();
    const int dim = other.dimension();
    tds.set_dimension(dim);
    const auto ours = [&](typename Plain::Vertex_handle v) { return vertex_of(index_of(other, v)); };
    std::vector<Cell_handle> cell;
    std::vector<typename Plain::Cell_handle> source;
    for (auto c = other.tds().cells().begin(); c != other.tds().cells().end(); ++c) {
        c->set_cell(static_cast<Index>(cell.size()));
        source.push_back(c);
        cell.push_back(tds.create_cell());
    }
    for (std::size_t k = 0; k < cell.size(); ++k)
        for (int i = 0; i <= std::max(dim, 0); ++i) {
            if (source[k]->vertex(i) != typename Plain::Vertex_handle())
                cell[k]->set_vertex(i, ours(source[k]->vertex(i)));
            if (source[k]->neighbor(i) != typename Plain::Cell_handle())
                cell[k]->set_neighbor(i, cell[at(source[k]->neighbor(i)->cell())]);
        }
    for (auto v = other.tds().vertices().begin(); v != other.tds().vertices().end(); ++v) {
        const typename Plain::Vertex_handle from = v;
        const Vertex_handle to = ours(from);
        to->set_cell(from->cell() == typename Plain::Cell_handle() ? Cell_handle() : cell[at(from->cell()->cell())]);
        if (!other.is_infinite(from)) to->set_point(from->point());
    }
}

template <class Info>
void Cgal_embedding_3<Info>::set_points(std::span<const Coordinates<3>> x) {
    for (std::size_t i = 0; i < handle_.size(); ++i)
        if (handle_[i] != Vertex_handle()) handle_[i]->set_point(point(x[i]));
}

}  // namespace annulus
