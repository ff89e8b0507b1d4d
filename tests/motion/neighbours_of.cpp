// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighbours_of.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstddef>
#include <utility>

annulus::Neighbours_2 neighbours_of(const std::vector<annulus::Coordinates<2>>& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<annulus::Index, Kernel>;
    using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base>>;
    std::vector<std::pair<Kernel::Point_2, annulus::Index>> numbered;
    for (std::size_t i = 0; i < points.size(); ++i)
        numbered.emplace_back(Kernel::Point_2(points[i][0], points[i][1]), static_cast<annulus::Index>(i));
    const Delaunay delaunay(numbered.begin(), numbered.end());
    std::vector<std::vector<annulus::Index>> list(points.size());
    annulus::Neighbours_2 result;
    result.hull.assign(points.size(), delaunay.dimension() < 2);
    if (delaunay.dimension() == 2)
        for (const auto v : delaunay.finite_vertex_handles()) {
            auto& of = list[static_cast<std::size_t>(v->info())];
            auto edge = delaunay.incident_vertices(v), begin = edge;
            do
                if (delaunay.is_infinite(edge)) begin = edge;
            while (++edge != delaunay.incident_vertices(v));
            edge = begin;
            do
                if (delaunay.is_infinite(edge)) result.hull[static_cast<std::size_t>(v->info())] = 1;
                else of.push_back(edge->info());
            while (++edge != begin);
        }
    else if (delaunay.dimension() == 1)
        for (const auto& edge : delaunay.finite_edges()) {
            const auto a = edge.first->vertex(0)->info(), b = edge.first->vertex(1)->info();
            list[static_cast<std::size_t>(a)].push_back(b);
            list[static_cast<std::size_t>(b)].push_back(a);
        }
    result.begin.push_back(0);
    for (const auto& of : list) {
        result.vertex.insert(result.vertex.end(), of.begin(), of.end());
        result.begin.push_back(static_cast<annulus::Index>(result.vertex.size()));
    }
    return result;
}
