// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/star_2.h>
#include <annulus/mesh/measures.h>
#include <annulus/mesh/neighbours.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace annulus::cgal_2 {

// What is read off the whole of CGAL's object, at CGAL's points. O(n) each.

/// Calls visit(vertices) for each finite cell; edges (padded with `none`) when all points are collinear.
template <class Tr, class Visit>
void for_each_finite_cell(const Tr& tr, Visit visit) {
    if (tr.dimension() == 2) {
        for (auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
            visit(std::array<Index, 3>{f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()});
    } else if (tr.dimension() == 1) {
        for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
            visit(std::array<Index, 3>{e->first->vertex(0)->index(), e->first->vertex(1)->index(), none});
    }
}

/// Widths, tolerances and theta of everything; `bound` is one more than the largest vertex index.
template <class Tr>
[[nodiscard]] Measures measure(const Tr& tr, std::size_t bound) {
    using Vertex_handle = typename Tr::Vertex_handle;
    Measures m;
    m.tolerance.assign(bound, std::numeric_limits<double>::infinity());
    if (tr.dimension() != 2) return m;
    const auto lower = [&](Vertex_handle v, double tolerance) {
        if (tr.is_infinite(v)) return;
        double& t = m.tolerance[static_cast<std::size_t>(v->index())];
        t = std::min(t, tolerance);
    };
    for (auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f) {
        const double t = face_verdict(tr, f).tolerance;
        for (int i = 0; i <= 2; ++i) lower(f->vertex(i), t);
    }
    for (auto e = tr.all_edges_begin(); e != tr.all_edges_end(); ++e) {
        const auto [f, i] = *e;
        const double t = edge_verdict(tr, f, i).tolerance;
        lower(f->vertex(i), t);
        lower(tr.tds().mirror_vertex(f, i), t);
        lower(f->vertex(tr.ccw(i)), t);
        lower(f->vertex(tr.cw(i)), t);
        if (!finite_bicell(tr, f, i)) continue;
        m.annulus_width.push_back(2.0 * t);
        m.theta_min = std::min(m.theta_min, edge_theta(tr, f, i));
    }
    return m;
}

/// The neighbours of every vertex; handle[i] is vertex i, null where the index is vacant.
template <class Tr>
void read_neighbours(const Tr& tr, std::span<const typename Tr::Vertex_handle> handle, Neighbours_2& out) {
    out.begin.assign(1, 0);
    out.vertex.clear();
    out.hull.clear();
    out.vertex.reserve(6 * handle.size());
    std::vector<Index> ring;
    for (const auto v : handle) {
        const bool lives = v != typename Tr::Vertex_handle();
        bool hull = lives && tr.dimension() != 2;
        ring.clear();
        if (lives && tr.dimension() >= 1) {
            std::size_t start = 0;  // where the list begins: after infinity
            auto w = tr.incident_vertices(v);
            const auto done = w;
            do {
                if (tr.is_infinite(w)) {
                    hull = true;
                    start = ring.size();
                } else {
                    ring.push_back(w->index());
                }
            } while (++w != done);
            if (tr.dimension() == 2)
                std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
        }
        out.vertex.insert(out.vertex.end(), ring.begin(), ring.end());
        out.begin.push_back(static_cast<Index>(out.vertex.size()));
        out.hull.push_back(hull ? 1 : 0);
    }
}

}  // namespace annulus::cgal_2
