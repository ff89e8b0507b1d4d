// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/triangulation/flips_3.h>

namespace annulus {

namespace {

bool is_edge(const Cell_table<3>& t, Index p, Index q) {
    if (p == q) return true;
    bool found = false;
    t.for_each_corner(p == infinite ? q : p,
                      [&](Index h) { found = found || t.slot(t.cell_of(h), p == infinite ? p : q) >= 0; });
    return found;
}

bool is_facet(const Cell_table<3>& t, Index p, Index q, Index r) {
    if (p == infinite) std::swap(p, q);
    bool found = false;
    t.for_each_corner(p, [&](Index h) {
        const Index c = t.cell_of(h);
        found = found || (t.slot(c, q) >= 0 && t.slot(c, r) >= 0);
    });
    return found;
}

}  // namespace

std::optional<Flip_3> flip_2_3(const Cell_table<3>& t, Index h) {
    const auto [a, b, c, q] = facet_and_vertex(t, h);
    const Index p = t.vertex(t.twin(h));
    if (is_edge(t, p, q)) return std::nullopt;
    Flip_3 flip;
    flip.take(t.cell_of(h));
    flip.take(t.cell_of(t.twin(h)));
    flip.put({a, b, p, q});
    flip.put({b, c, p, q});
    flip.put({c, a, p, q});
    return flip;
}

std::optional<Flip_3> flip_3_2(const Cell_table<3>& t, Index cell, int i, int j) {
    // The edge p q, and the other corners a and b so that a, b, p, q is in positive order.
    const Index edge = t.corner(cell, j);
    const auto& facing = facing_corners[static_cast<std::size_t>(j)];
    std::size_t k = 0;
    while (facing[k] != i) ++k;
    const Index corner_a = t.corner(cell, facing[(k + 1) % 3]);
    const Index corner_b = t.corner(cell, facing[(k + 2) % 3]);
    const Index a = t.vertex(corner_a);
    const Index b = t.vertex(corner_b);
    const Index p = t.vertex(t.corner(cell, i));
    const Index q = t.vertex(edge);
    const Index over_a = t.twin(corner_a);  // the cell b p q c
    const Index over_b = t.twin(corner_b);  // the cell a p q c
    const Index c = t.vertex(over_a);
    if (c != t.vertex(over_b)) return std::nullopt;
    const Index one = t.cell_of(over_a);
    const Index other = t.cell_of(over_b);
    if (t.cell_of(t.twin(t.corner(one, t.slot(one, b)))) != other) return std::nullopt;
    if (is_facet(t, a, b, c)) return std::nullopt;
    Flip_3 flip;
    flip.take(cell);
    flip.take(one);
    flip.take(other);
    flip.put({a, b, c, q});
    flip.put({b, a, c, p});
    return flip;
}

std::optional<Flip_3> flip_4_4(const Cell_table<3>& t, Index h, Index k) {
    Cell_points<3> x = facet_and_vertex(t, h);
    const Index a = t.vertex(k);
    while (x[0] != a) x = {x[1], x[2], x[0], x[3]};
    const Index b = x[1];
    const Index c = x[2];
    const Index q = x[3];
    const Index cell_q = t.cell_of(h);
    const Index cell_p = t.cell_of(t.twin(h));
    const Index p = t.vertex(t.twin(h));
    const Index over_q = t.twin(t.corner(cell_q, t.slot(cell_q, a)));
    const Index over_p = t.twin(t.corner(cell_p, t.slot(cell_p, a)));
    const Index r = t.vertex(over_q);
    const Index one = t.cell_of(over_q);
    const Index other = t.cell_of(over_p);
    if (r != t.vertex(over_p) || one == cell_p || r == a) return std::nullopt;
    if (t.cell_of(t.twin(t.corner(one, t.slot(one, q)))) != other) return std::nullopt;
    if (is_edge(t, p, q)) return std::nullopt;
    Flip_3 flip;
    flip.take(cell_q);
    flip.take(cell_p);
    flip.take(one);
    flip.take(other);
    flip.put({a, b, p, q});
    flip.put({c, a, p, q});
    flip.put({b, r, p, q});
    flip.put({r, c, p, q});
    return flip;
}

}  // namespace annulus
