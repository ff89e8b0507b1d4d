// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <map>

namespace annulus::oracle {

Cells rebuilt_cells(const Sites& sites) {
    Delaunay_2<No_info> tr;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (sites[i])
            tr.insert(Delaunay_2<No_info>::Point((*sites[i])[0], (*sites[i])[1]))->set_index(static_cast<Index>(i));
    return cells_of(tr);
}

namespace {

struct Rational_point {
    mpq_class x, y;
};

Rational_point rational(const Position& p) { return {mpq_class(p[0]), mpq_class(p[1])}; }
mpq_class turn(const Rational_point& a, const Rational_point& b, const Rational_point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
mpq_class squared_distance(const Rational_point& a, const Rational_point& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

mpf_class real(const mpq_class& q) { return {q, precision}; }
mpf_class root(const mpq_class& q) { return sqrt(real(q)); }

}  // namespace

mpf_class half_altitude(const Position& a, const Position& b, const Position& c) {
    const Rational_point A = rational(a);
    const Rational_point B = rational(b);
    const Rational_point C = rational(c);
    const mpq_class area = turn(A, B, C);
    if (area <= 0) return {0, precision};
    const mpq_class side = std::max({squared_distance(A, B), squared_distance(B, C), squared_distance(C, A)});
    return real(area) / (2 * root(side));
}

mpf_class half_annulus(const Position& a, const Position& b, const Position& p, const Position& q) {
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

std::vector<mpf_class> vertex_tolerances(const Moving_delaunay_2::Triangulation& tr, const Sites& sites) {
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
