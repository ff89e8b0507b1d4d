// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_embedding_3: certificates evaluated on CGAL's object, at CGAL's points.
#include <annulus/cgal/embedding_3.h>
#include <annulus/mesh/degenerate.h>

#include <algorithm>

namespace annulus {

template <class Info>
void Cgal_embedding_3<Info>::drop_mirror() noexcept {
    mirrored_ = false;
    table_ = {};
    cell_ = {};
    mark_ = {};
}

template <class Info>
Sample Cgal_embedding_3<Info>::sample(std::span<const Coordinates<3>> x, std::size_t count) const {
    Sample sample;
    if (tr_.dimension() != 3) return sample;
    const std::size_t stride = 1 + handle_.size() / (count + 1);
    for (std::size_t v = 0; v < handle_.size(); v += stride) {
        if (handle_[v] == Vertex_handle()) continue;
        const Cell_handle c = handle_[v]->cell();
        if (tr_.is_infinite(c)) continue;
        std::array<Index, 4> corner{};
        std::array<Index, 4> beyond{};
        for (int i = 0; i <= 3; ++i) {
            corner[static_cast<std::size_t>(i)] = c->vertex(i)->index();
            const Vertex_handle w = tr_.tds().mirror_vertex(c, i);
            beyond[static_cast<std::size_t>(i)] = tr_.is_infinite(w) ? infinite : w->index();
        }
        add_cell<3>(sample, x, corner, beyond);
    }
    return sample;
}

/// The vertices of a bi-cell as the ladder takes them: a, b, c, p, q with q the vertex of f's own cell.
template <class Info>
auto Cgal_embedding_3<Info>::bicell(const Facet& f) const -> std::array<Vertex_handle, 5> {
    const auto [c, i] = f;
    const auto& facing = facing_corners[static_cast<std::size_t>(i)];
    return {c->vertex(facing[0]), c->vertex(facing[1]), c->vertex(facing[2]), tr_.tds().mirror_vertex(c, i),
            c->vertex(i)};
}

/// The verdict of a facet, with the perturbation deciding cospherical points; positive where it has no certificate of its own.
template <class Info>
Verdict Cgal_embedding_3<Info>::facet_verdict(const Facet& f) const {
    const bool one = tr_.is_infinite(f.first);
    const bool other = tr_.is_infinite(f.first->neighbor(f.second));
    if (one != other) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    const auto v = bicell(f);
    std::array<Coordinates<3>, 5> x{};
    for (std::size_t k = 0; k < 5; ++k)
        if (!tr_.is_infinite(v[k])) x[k] = coordinates(v[k]->point());
    if (!one) {
        const Tuple<3, 5> points{&x[0], &x[1], &x[2], &x[3], &x[4]};
        Verdict out = empty_sphere_verdict(points);
        if (out.sign == 0) out.sign = static_cast<std::int8_t>(perturbed_sign(points));
        return out;
    }
    // a b c q is positive with infinity among a, b, c; with p in its place it is negative where the hull is convex. The
    // two others and q, p: turned so that the ridge comes first, an even number of swaps, and one for the sign.
    std::size_t k = 0;
    while (!tr_.is_infinite(v[k])) ++k;
    const Coordinates<3>& u = x[(k + 1) % 3];
    const Coordinates<3>& w = x[(k + 2) % 3];
    // (k, k+1, k+2) is an even turn of (a, b, c): p u w q positive means concave; u w q p has the opposite sign.
    const Tuple<3, 4> ridge{&u, &w, &x[4], &x[3]};
    Verdict out = orientation_verdict(ridge);
    if (out.sign == 0) out.sign = flat_ridge_holds(ridge) ? 1 : -1;
    return out;
}

template <class Info>
Verdict Cgal_embedding_3<Info>::cell_verdict(Cell_handle c) const {
    if (tr_.is_infinite(c)) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    std::array<Coordinates<3>, 4> x{};
    for (std::size_t k = 0; k < 4; ++k) x[k] = coordinates(c->vertex(static_cast<int>(k))->point());
    return orientation_verdict({&x[0], &x[1], &x[2], &x[3]});
}

/// Every facet whose bi-cell contains v, those that contain v themselves twice.
template <class Info>
template <class Visit>
void Cgal_embedding_3<Info>::for_each_facet_around(Vertex_handle v, Visit visit) const {
    for (const Cell_handle c : star(v))
        for (int i = 0; i <= 3; ++i) visit(Facet(c, i));
}

template <class Info>
double Cgal_embedding_3<Info>::star_tolerance(Index v) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Cell_handle c : star(handle_[at(v)])) least = std::min(least, cell_verdict(c).tolerance);
    for_each_facet_around(handle_[at(v)], [&](const Facet& f) { least = std::min(least, facet_verdict(f).tolerance); });
    return least;
}

template <class Info>
double Cgal_embedding_3<Info>::facet_theta(const Facet& f) const {
    const auto v = bicell(f);
    return annulus::theta(coordinates(v[0]->point()), coordinates(v[1]->point()), coordinates(v[2]->point()),
                          coordinates(v[3]->point()), coordinates(v[4]->point()));
}

template <class Info>
double Cgal_embedding_3<Info>::theta(Index v) const {
    double least = 1.5707963267948966;  // pi / 2
    if (tr_.dimension() != 3) return least;
    for_each_facet_around(handle_[at(v)], [&](const Facet& f) {
        if (tr_.is_infinite(f.first) || tr_.is_infinite(f.first->neighbor(f.second))) return;
        least = std::min(least, facet_theta(f));
    });
    return least;
}

template <class Info>
Measures Cgal_embedding_3<Info>::measure() const {
    Measures m;
    m.tolerance.assign(handle_.size(), std::numeric_limits<double>::infinity());
    if (tr_.dimension() != 3) return m;
    const auto lower = [&](Vertex_handle v, double tolerance) {
        if (tr_.is_infinite(v)) return;
        double& t = m.tolerance[at(v->index())];
        t = std::min(t, tolerance);
    };
    for (auto c = tr_.finite_cells_begin(); c != tr_.finite_cells_end(); ++c) {
        const double t = cell_verdict(c).tolerance;
        for (int i = 0; i <= 3; ++i) lower(c->vertex(i), t);
    }
    for (auto f = tr_.all_facets_begin(); f != tr_.all_facets_end(); ++f) {
        const Facet facet(f->first, f->second);
        const double t = facet_verdict(facet).tolerance;
        const auto v = bicell(facet);
        for (const Vertex_handle w : v) lower(w, t);
        if (tr_.is_infinite(f->first) || tr_.is_infinite(f->first->neighbor(f->second))) continue;
        std::array<Coordinates<3>, 5> x{};
        for (std::size_t k = 0; k < 5; ++k) x[k] = coordinates(v[k]->point());
        m.annulus_width.push_back(
            2.0 * empty_sphere_verdict({&x[0], &x[1], &x[2], &x[3], &x[4]}, true, Cell_widths::never).tolerance);
        m.theta_min = std::min(m.theta_min, facet_theta(facet));
    }
    return m;
}

template <class Info>
template <class Visit>
void Cgal_embedding_3<Info>::for_each_finite_cell(Visit visit) const {
    using Cell = std::array<Index, 4>;
    if (tr_.dimension() == 3) {
        for (auto c = tr_.finite_cells_begin(); c != tr_.finite_cells_end(); ++c)
            visit(Cell{c->vertex(0)->index(), c->vertex(1)->index(), c->vertex(2)->index(), c->vertex(3)->index()});
    } else if (tr_.dimension() == 2) {
        for (auto f = tr_.finite_facets_begin(); f != tr_.finite_facets_end(); ++f)
            visit(Cell{f->first->vertex(0)->index(), f->first->vertex(1)->index(), f->first->vertex(2)->index(), none});
    } else if (tr_.dimension() == 1) {
        for (auto e = tr_.finite_edges_begin(); e != tr_.finite_edges_end(); ++e)
            visit(Cell{e->first->vertex(e->second)->index(), e->first->vertex(e->third)->index(), none, none});
    }
}

}  // namespace annulus
