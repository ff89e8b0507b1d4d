// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the fuzz targets and the property tests hold the library against: a fresh CGAL triangulation of the same
// points, and the tolerance of a vertex in rational arithmetic. Nothing here calls the library's arithmetic.

#include <annulus/moving_delaunay_2.h>

#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace annulus::oracle {

/// The library's object of one dimension, and its points.
template <int d>
struct Space;

/// Sorted. In the plane each is turned so that its least vertex comes first; edges are (a < b, none). In space each is sorted,
/// padded with `none` in front where points are flat.
template <int d>
using Cells_of = std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>>;
template <int d>
using Sites_of = std::vector<std::optional<Coordinates<d>>>;  ///< by vertex index; empty for a vacant one

template <>
struct Space<2> {
    using Moving = Moving_delaunay_2;
    static Moving::Point point(const Coordinates<2>& p) { return {p[0], p[1]}; }
    static Coordinates<2> coordinates(const Moving::Point& p) { return {p.x(), p.y()}; }
};

using Position = Coordinates<2>;
using Cell = std::array<Index, 3>;
using Cells = Cells_of<2>;
using Sites = Sites_of<2>;

[[nodiscard]] inline Cell canonical(Cell c) {
    if (c[2] == none) return {std::min(c[0], c[1]), std::max(c[0], c[1]), none};
    std::rotate(c.begin(), std::min_element(c.begin(), c.end()), c.end());
    return c;
}

/// The finite cells of any triangulation of the plane whose vertices have an `index()`.
template <class Triangulation>
[[nodiscard]] Cells cells_of(const Triangulation& tr) requires requires {
    tr.finite_faces_begin();
}
{
    Cells cells;
    if (tr.dimension() == 2)
        for (auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
            cells.push_back(canonical({f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()}));
    if (tr.dimension() == 1)
        for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
            cells.push_back(canonical({e->first->vertex(0)->index(), e->first->vertex(1)->index(), none}));
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// The same of CGAL's Delaunay triangulation of the sites, built from nothing.
[[nodiscard]] inline Cells rebuilt_cells(const Sites& sites) {
    Delaunay_2<No_info> tr;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites[i])
            tr.insert(Delaunay_2<No_info>::Point((*sites[i])[0], (*sites[i])[1]))->set_index(static_cast<Index>(i));
    return cells_of(tr);
}

// ---- Tolerances in rational arithmetic ----------------------------------------------------------------------------

struct Rational_point {
    mpq_class x, y;
};

[[nodiscard]] inline Rational_point rational(const Position& p) { return {mpq_class(p[0]), mpq_class(p[1])}; }
[[nodiscard]] inline mpq_class turn(const Rational_point& a, const Rational_point& b, const Rational_point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
[[nodiscard]] inline mpq_class squared_distance(const Rational_point& a, const Rational_point& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

inline constexpr mp_bitcnt_t precision = 320;
[[nodiscard]] inline mpf_class real(const mpq_class& q) { return {q, precision}; }
[[nodiscard]] inline mpf_class root(const mpq_class& q) { return sqrt(real(q)); }

/// Half the least altitude of a triangle that turns left, to 300 bits; 0 when it does not.
[[nodiscard]] inline mpf_class half_altitude(const Position& a, const Position& b, const Position& c) {
    const Rational_point A = rational(a);
    const Rational_point B = rational(b);
    const Rational_point C = rational(c);
    const mpq_class area = turn(A, B, C);
    if (area <= 0) return {0, precision};
    const mpq_class side = std::max({squared_distance(A, B), squared_distance(B, C), squared_distance(C, A)});
    return real(area) / (2 * root(side));
}

/// Half the width of the standard annulus of the edge a b, p right of it and q left, by its centre; 0 when the circle
/// is not empty.
[[nodiscard]] inline mpf_class half_annulus(const Position& a, const Position& b, const Position& p,
                                            const Position& q) {
    const Rational_point A = rational(a);
    const Rational_point B = rational(b);
    const Rational_point P = rational(p);
    const Rational_point Q = rational(q);
    // The centre c is as far from a as from b and as far from p as from q: two linear equations.
    const mpq_class ux = B.x - A.x;
    const mpq_class uy = B.y - A.y;
    const mpq_class vx = Q.x - P.x;
    const mpq_class vy = Q.y - P.y;
    const mpq_class det = ux * vy - uy * vx;
    if (det == 0) return {0, precision};
    const mpq_class r1 = (B.x * B.x + B.y * B.y - A.x * A.x - A.y * A.y) / 2;
    const mpq_class r2 = (Q.x * Q.x + Q.y * Q.y - P.x * P.x - P.y * P.y) / 2;
    const Rational_point c{(r1 * vy - uy * r2) / det, (ux * r2 - r1 * vx) / det};
    const mpq_class inner = squared_distance(c, A);
    const mpq_class outer = squared_distance(c, P);
    if (outer <= inner) return {0, precision};
    return real(outer - inner) / (2 * (root(outer) + root(inner)));
}

/// The least tolerance of the certificates of every vertex of a Delaunay triangulation of the sites; by index, 0 for a
/// vacant one and for sites on one line.
template <class Triangulation>
[[nodiscard]] std::vector<mpf_class> vertex_tolerances(const Triangulation& tr, const Sites& sites) {
    std::vector<mpf_class> least(sites.size(), mpf_class(0, precision));
    std::vector<char> known(sites.size(), 0);
    if (tr.dimension() != 2) return least;
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    const auto site = [&](Index i) { return *sites[at(i)]; };
    const auto take = [&](std::initializer_list<Index> vertices, const mpf_class& s) {
        for (const Index v : vertices) {
            if (!known[at(v)] || s < least[at(v)]) least[at(v)] = s;
            known[at(v)] = 1;
        }
    };
    std::map<Index, Index> next;  // along the hull
    std::map<Index, Index> previous;
    for (auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f) {
        const Cell v{f->vertex(0)->index(), f->vertex(1)->index(), f->vertex(2)->index()};
        take({v[0], v[1], v[2]}, half_altitude(site(v[0]), site(v[1]), site(v[2])));
        for (int i = 0; i < 3; ++i) {
            const Index a = v[at((i + 1) % 3)];
            const Index b = v[at((i + 2) % 3)];
            if (tr.is_infinite(f->neighbor(i))) {
                next[a] = b;
                previous[b] = a;
                continue;
            }
            const Index p = tr.tds().mirror_vertex(f, i)->index();
            const Index q = v[at(i)];
            if (q < p) continue;
            take({a, b, p, q}, half_annulus(site(a), site(b), site(p), site(q)));
        }
    }
    for (const auto& [a, b] : next) {
        const Index c = next.at(b);
        take({a, b, c}, half_altitude(site(a), site(b), site(c)));
    }
    return least;
}

}  // namespace annulus::oracle
