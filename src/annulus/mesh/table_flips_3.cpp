// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/table_flips_3.h>

#include <annulus/mesh/certificates.h>

#include <algorithm>
#include <cassert>

namespace annulus::inline v1 {

namespace {

/// The half-facet on the other side of the facet opposite to v, in a cell that goes.
Corner_index beyond(const Corner_table<3>& t, Cell_index c, Site<3> v) { return t.twin(t.corner(c, t.slot(c, v))); }

void fill(Corner_table<3>& t, Cell_index c, const Cell_sites<3>& x) {
    for (int i = 0; i <= 3; ++i) t.set_site(t.corner(c, i), x[static_cast<std::size_t>(i)]);
}

}  // namespace

bool flip_facet(Corner_table<3>& t, Corner_index h, std::array<Cell_index, 3>& made) {
    const Cell_sites<3> x = facet_and_vertex(t, h);
    const Site<3> q = x[3];
    const Site<3> p = t.opposite(h);
    const Cell_index cell_q = t.cell_of(h);
    const Cell_index cell_p = t.cell_of(t.twin(h));
    if (p == q) return false;
    std::array<Corner_index, 3> at_q{};  // opposite to x[i]
    std::array<Corner_index, 3> at_p{};
    const auto goes = [&](Corner_index b) { return t.cell_of(b) == cell_q || t.cell_of(b) == cell_p; };
    for (std::size_t i = 0; i < 3; ++i) {
        at_q[i] = beyond(t, cell_q, x[i]);
        at_p[i] = beyond(t, cell_p, x[i]);
        if (goes(at_q[i]) || goes(at_p[i])) return false;
    }
    made = {cell_q, cell_p, t.new_cell()};
    for (std::size_t i = 0; i < 3; ++i) fill(t, made[i], {x[i], x[(i + 1) % 3], p, q});
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t off = (i + 2) % 3;
        t.set_adjacency(t.corner(made[i], 2), at_q[off]);
        t.set_adjacency(t.corner(made[i], 3), at_p[off]);
        t.set_adjacency(t.corner(made[i], 0), t.corner(made[(i + 1) % 3], 1));
    }
    return true;
}

bool flip_edge(Corner_table<3>& t, Corner_index h, Corner_index k, std::array<Cell_index, 3>& made) {
    assert(h != k && t.cell_of(h) == t.cell_of(k));
    Cell_sites<3> x = facet_and_vertex(t, h);
    while (x[2] != t.site(k)) x = {x[1], x[2], x[0], x[3]};
    const auto [a, b, c, q] = x;
    const Site<3> p = t.opposite(h);
    const Cell_index cell_q = t.cell_of(h);
    const Cell_index cell_p = t.cell_of(t.twin(h));
    const Corner_index beyond_q = beyond(t, cell_q, c);
    const Cell_index cell_pq = t.cell_of(beyond_q);
    if (p == q || cell_pq == cell_q || cell_pq == cell_p || t.site(beyond_q) != p) return false;
    if (t.cell_of(beyond(t, cell_p, c)) != cell_pq || beyond(t, cell_pq, q) != t.corner(cell_p, t.slot(cell_p, c)))
        return false;
    const std::array<Corner_index, 3> at_a{beyond(t, cell_q, a), beyond(t, cell_pq, a), beyond(t, cell_p, a)};
    const std::array<Corner_index, 3> at_b{beyond(t, cell_q, b), beyond(t, cell_pq, b), beyond(t, cell_p, b)};
    const auto goes = [&](Corner_index out) {
        const Cell_index n = t.cell_of(out);
        return n == cell_q || n == cell_p || n == cell_pq;
    };
    if (std::any_of(at_a.begin(), at_a.end(), goes) || std::any_of(at_b.begin(), at_b.end(), goes)) return false;
    t.free_cell(cell_pq);
    made = {cell_q, cell_p, cell_pq};
    fill(t, cell_q, {c, q, p, b});
    fill(t, cell_p, {q, c, p, a});
    constexpr std::array<int, 3> in_q{2, 0, 1};
    constexpr std::array<int, 3> in_p{2, 1, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        t.set_adjacency(t.corner(cell_q, in_q[i]), at_a[i]);
        t.set_adjacency(t.corner(cell_p, in_p[i]), at_b[i]);
    }
    t.set_adjacency(t.corner(cell_q, 3), t.corner(cell_p, 3));
    return true;
}

std::optional<Flip_4_4> flip_4_4(const Corner_table<3>& t, Corner_index h, Corner_index k) {
    assert(h != k && t.cell_of(h) == t.cell_of(k));
    Cell_sites<3> x = facet_and_vertex(t, h);
    while (x[2] != t.site(k)) x = {x[1], x[2], x[0], x[3]};
    const auto [u, w, c, q] = x;
    const Site<3> p = t.opposite(h);
    const Cell_index cell_q = t.cell_of(h);
    const Cell_index cell_p = t.cell_of(t.twin(h));
    const Corner_index beyond_q = beyond(t, cell_q, c);
    const Corner_index beyond_p = beyond(t, cell_p, c);
    const Site<3> r = t.site(beyond_q);
    const Cell_index cell_qr = t.cell_of(beyond_q);
    const Cell_index cell_pr = t.cell_of(beyond_p);
    if (r != t.site(beyond_p) || cell_qr == cell_p || cell_qr == cell_pr || cell_pr == cell_q || r == c || p == q)
        return std::nullopt;
    if (t.cell_of(beyond(t, cell_qr, q)) != cell_pr) return std::nullopt;
    const std::array<Cell_index, 4> gone{cell_q, cell_p, cell_qr, cell_pr};
    for (const Cell_index cell : gone)
        for (const Site<3> v : {u, w})
            if (std::find(gone.begin(), gone.end(), t.cell_of(beyond(t, cell, v))) != gone.end()) return std::nullopt;
    return Flip_4_4{
        gone,
        {Cell_sites<3>{w, c, p, q}, Cell_sites<3>{c, u, p, q}, Cell_sites<3>{r, w, p, q}, Cell_sites<3>{u, r, p, q}}};
}

}  // namespace annulus::inline v1
