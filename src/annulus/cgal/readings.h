// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding: what is read off CGAL's object, at CGAL's points. Nothing here needs the mirror.
#include <annulus/cgal/embedding.h>

#include <algorithm>
#include <limits>

namespace annulus {

template <class Traits>
auto Cgal_embedding<Traits>::certificate(Cell_handle c, int i) const -> Certificate {
    const Facet_certificate<d> f =
        facet_certificate<d>(points_of(tr_, c), static_cast<std::size_t>(i), index_of(tr_, vertex_beyond(c, i)));
    Certificate out{f.kind, f.point, {}};
    for (std::size_t k = 0; k < f.point.size(); ++k)
        if (f.point[k] != none) out.x[k] = coordinates(handle_[at(f.point[k])]->point());
    return out;
}

template <class Traits>
Verdict Cgal_embedding<Traits>::verdict_of_cell(Cell_handle c) const {
    if (tr_.is_infinite(c)) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)> x{};
    for (int i = 0; i <= d; ++i) x[static_cast<std::size_t>(i)] = coordinates(c->vertex(i)->point());
    return cell_verdict(x);
}

/// Every facet whose bi-cell contains v, those that contain v themselves twice.
template <class Traits>
template <class Visit>
void Cgal_embedding<Traits>::for_each_facet_around(Vertex_handle v, Visit visit) const {
    for (const Cell_handle c : star(v))
        for (int i = 0; i <= d; ++i) visit(c, i);
}

template <class Traits>
Sample Cgal_embedding<Traits>::sample(std::span<const Coordinates<d>> x, std::size_t count) const {
    Sample sample;
    if (tr_.dimension() != d) return sample;
    const std::size_t stride = 1 + handle_.size() / (count + 1);
    for (std::size_t v = 0; v < handle_.size(); v += stride) {
        if (handle_[v] == Vertex_handle()) continue;
        const Cell_handle c = Traits::cell_of(handle_[v]);
        if (tr_.is_infinite(c)) continue;
        Points beyond{};
        for (int i = 0; i <= d; ++i) beyond[static_cast<std::size_t>(i)] = index_of(tr_, vertex_beyond(c, i));
        add_cell(sample, x, points_of(tr_, c), beyond);
    }
    return sample;
}

template <class Traits>
double Cgal_embedding<Traits>::star_tolerance(std::span<const Coordinates<d>>, Index v) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Cell_handle c : star(handle_[at(v)])) least = std::min(least, verdict_of_cell(c).tolerance);
    for_each_facet_around(handle_[at(v)], [&](Cell_handle c, int i) {
        const Certificate f = certificate(c, i);
        least = std::min(least, facet_verdict(f.kind, f.x).tolerance);
    });
    return least;
}

template <class Traits>
double Cgal_embedding<Traits>::theta(std::span<const Coordinates<d>>, Index v) const {
    double least = 1.5707963267948966;  // pi / 2
    if (tr_.dimension() != d) return least;
    for_each_facet_around(handle_[at(v)], [&](Cell_handle c, int i) {
        const Certificate f = certificate(c, i);
        if (f.kind == Facet_kind::empty_sphere) least = std::min(least, bicell_theta(f.x));
    });
    return least;
}

template <class Traits>
Measures Cgal_embedding<Traits>::measure(std::span<const Coordinates<d>>) const {
    Measures m;
    m.tolerance.assign(handle_.size(), std::numeric_limits<double>::infinity());
    if (tr_.dimension() != d) return m;
    const auto lower = [&](Index v, double tolerance) {
        if (v == none) return;
        double& t = m.tolerance[at(v)];
        t = std::min(t, tolerance);
    };
    Traits::for_each_cell(tr_, [&](Cell_handle c) {
        if (!tr_.is_infinite(c)) {
            const double t = verdict_of_cell(c).tolerance;
            for (int i = 0; i <= d; ++i) lower(c->vertex(i)->index(), t);
        }
        for (int i = 0; i <= d; ++i) {
            if (index_of(tr_, vertex_beyond(c, i)) < index_of(tr_, c->vertex(i))) continue;  // a facet is seen from two cells
            const Certificate f = certificate(c, i);
            if (f.kind == Facet_kind::nothing) continue;
            const double t = facet_verdict(f.kind, f.x).tolerance;
            for (const Index v : f.point) lower(v, t);
            if (f.kind != Facet_kind::empty_sphere) continue;
            m.annulus_width.push_back(annulus_width_lower(f.x));
            m.theta_min = std::min(m.theta_min, bicell_theta(f.x));
        }
    });
    return m;
}

template <class Traits>
auto Cgal_embedding<Traits>::cells(std::size_t bound) const -> Mesh_cells<d> {
    if (mirrored_ && tr_.dimension() == d) return mesh_cells(table_);
    std::vector<Index> corners;
    list_cells(corners);
    return mesh_cells<d>(corners, bound);
}

template <class Traits>
void Cgal_embedding<Traits>::list_all_cells(std::vector<Index>& vertices) const {
    if (tr_.dimension() != d) return list_cells(vertices);
    Traits::for_each_cell(tr_, [&](Cell_handle c) {
        const Points v = points_of(tr_, c);
        vertices.insert(vertices.end(), v.begin(), v.end());
    });
}

template <class Traits>
template <class Visit>
void Cgal_embedding<Traits>::for_each_finite_cell(Visit visit) const {
    Points x{};
    x.fill(none);
    if (tr_.dimension() == d) {
        Traits::for_each_cell(tr_, [&](Cell_handle c) {
            if (!tr_.is_infinite(c)) visit(points_of(tr_, c));
        });
    } else if (tr_.dimension() == 2) {
        if constexpr (d == 3)
            for (auto f = tr_.finite_facets_begin(); f != tr_.finite_facets_end(); ++f) {
                for (int i = 0; i < 3; ++i) x[static_cast<std::size_t>(i)] = f->first->vertex(i)->index();
                visit(x);
            }
    } else if (tr_.dimension() == 1) {
        for (auto e = tr_.finite_edges_begin(); e != tr_.finite_edges_end(); ++e) {
            for (int i = 0; i < 2; ++i) x[static_cast<std::size_t>(i)] = e->first->vertex(i)->index();
            visit(x);
        }
    }
}

template <class Traits>
void Cgal_embedding<Traits>::neighbours([[maybe_unused]] Neighbour_lists& out) const {
    if constexpr (d == 2) read_neighbours(tr_, std::span<const Vertex_handle>(handle_), out);
}

}  // namespace annulus
