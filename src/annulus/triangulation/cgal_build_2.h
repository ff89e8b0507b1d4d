// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/error.h>
#include <annulus/triangulation/cgal_types_2.h>

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace annulus::cgal_2 {

/// CGAL's own triangulation, with nothing but the input order at its vertices: what a rebuild is timed with.
using Plain_delaunay = CGAL::Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>,
                                                 Indexed_face_base_2<Kernel>>>;

/// Inserts x[i] for every i with live[i] (for all when `live` is empty) in the order of a spatial sort and calls
/// assign(vertex, i). Throws Error(collision) naming a point whose position another has.
/// CGAL's insert of a range of points with info does just this; here the assigner learns of duplicates.
template <class Tr, class Assign>
void insert_sorted(Tr& tr, std::span<const Coordinates<2>> x, std::span<const char> live, Assign assign) {
    using Point = typename Tr::Point;
    std::vector<Point> points;
    std::vector<std::size_t> order;
    points.reserve(x.size());
    order.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        const bool lives = live.empty() || live[i];
        points.push_back(lives ? Point(x[i][0], x[i][1]) : Point(0, 0));
        if (lives) order.push_back(i);
    }
    using Map = typename CGAL::Pointer_property_map<Point>::type;
    const CGAL::Spatial_sort_traits_adapter_2<Kernel, Map> traits(CGAL::make_property_map(points));
    CGAL::spatial_sort(order.begin(), order.end(), traits);
    typename Tr::Face_handle hint;
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

/// Gives the vertices of tr, which callers hold handles of, the faces and points of another triangulation of the same
/// set, whose vertex info is the index into `handle`.
template <class Tr>
void transplant(Tr& tr, Plain_delaunay& other, std::span<const typename Tr::Vertex_handle> handle) {
    using Vertex_handle = typename Tr::Vertex_handle;
    using Face_handle = typename Tr::Face_handle;
    using Their_vertex = Plain_delaunay::Vertex_handle;
    using Their_face = Plain_delaunay::Face_handle;
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    auto& tds = tr.tds();
    tds.faces().clear();
    const int dim = other.dimension();
    tds.set_dimension(dim);
    const auto ours = [&](Their_vertex v) -> Vertex_handle {
        return other.is_infinite(v) ? tr.infinite_vertex() : handle[at(v->info())];
    };
    std::vector<Face_handle> face;
    std::vector<Their_face> source;
    for (auto f = other.tds().faces().begin(); f != other.tds().faces().end(); ++f) {
        f->set_cell(static_cast<Index>(face.size()));
        source.push_back(f);
        face.push_back(tds.create_face());
    }
    for (std::size_t k = 0; k < face.size(); ++k)
        for (int i = 0; i <= std::max(dim, 0); ++i) {
            if (source[k]->vertex(i) != Their_vertex()) face[k]->set_vertex(i, ours(source[k]->vertex(i)));
            if (source[k]->neighbor(i) != Their_face())
                face[k]->set_neighbor(i, face[at(source[k]->neighbor(i)->cell())]);
        }
    for (auto v = other.tds().vertices().begin(); v != other.tds().vertices().end(); ++v) {
        const Their_vertex from = v;
        const Vertex_handle to = ours(from);
        to->set_face(from->face() == Their_face() ? Face_handle() : face[at(from->face()->cell())]);
        if (!other.is_infinite(from)) to->set_point(from->point());
    }
}

}  // namespace annulus::cgal_2
