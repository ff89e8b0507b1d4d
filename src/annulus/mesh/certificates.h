// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>
#include <annulus/predicate/certificate_value.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

/// The certificate that a facet owns (docs/theory.md 1). The orientation of a finite cell belongs to the cell.
enum class Facet_kind : std::uint8_t {
    empty_sphere,  ///< both cells finite
    nothing,       ///< one infinite cell: no certificate but the finite one's orientation; for a cell: it is infinite
    ridge,         ///< both cells infinite: the hull is convex there
    slab,          ///< the paper's view of a border facet: its own parallel hyperplanes (kind `paper` only)
};

/// Points of a certificate; a ridge leaves the last entry `none`.
template <int d>
using Facet_sites = std::array<Site<d>, static_cast<std::size_t>(d + 2)>;
template <int d>
using Cell_sites = std::array<Site<d>, static_cast<std::size_t>(d + 1)>;

template <int d>
[[nodiscard]] Facet_kind facet_kind(const Corner_table<d>& t, Corner_index h) {
    if (t.vertex(h) == infinite || t.vertex(t.twin(h)) == infinite) return Facet_kind::nothing;
    return t.is_infinite(t.cell_of(h)) ? Facet_kind::ridge : Facet_kind::empty_sphere;  // as the other cell
}

/// The corners of a cell, in positive order when it is finite. Infinity is the vertex `infinite`.
template <int d>
[[nodiscard]] Cell_sites<d> cell_sites(const Corner_table<d>& t, Cell_index c) {
    Cell_sites<d> x{};
    for (int i = 0; i <= d; ++i) x[static_cast<std::size_t>(i)] = t.site(t.corner(c, i));
    return x;
}

/// The vertices of a cell, for positions, reports and lists.
template <int d>
using Cell_vertices = std::array<Index, static_cast<std::size_t>(d + 1)>;
/// The sites of vertices that have one image each.
template <int d>
[[nodiscard]] Cell_sites<d> sites_of(const Cell_vertices<d>& v) {
    Cell_sites<d> x{};
    for (std::size_t i = 0; i <= d; ++i) x[i] = Site<d>(v[i]);
    return x;
}
template <int d>
[[nodiscard]] Cell_vertices<d> cell_vertices(const Corner_table<d>& t, Cell_index c) {
    Cell_vertices<d> v{};
    for (int i = 0; i <= d; ++i) v[static_cast<std::size_t>(i)] = t.vertex(t.corner(c, i));
    return v;
}

/// The points of a ridge, ordered so that their orientation is positive where the hull is strictly convex: an infinite
/// cell with infinity replaced by `beyond`, the corner opposite to its facet `slot` in the other cell, and two points
/// swapped (an infinite cell lies outside).
template <int d>
[[nodiscard]] Cell_sites<d> ridge_sites(Cell_sites<d> cell, Site<d> beyond) {
    for (Site<d>& s : cell)
        if (s.vertex == infinite) s = beyond;
    std::swap(cell[0], cell[1]);
    return cell;
}
template <int d>
[[nodiscard]] Cell_sites<d> ridge_sites(const Corner_table<d>& t, Corner_index h) {
    return ridge_sites<d>(cell_sites(t, t.cell_of(h)), t.opposite(h));
}

/// The points of a border facet for the paper's slab: its finite cell in positive order, the vertex off the facet
/// last.
[[nodiscard]] inline Cell_sites<2> slab_sites(const Corner_table<2>& t, Corner_index h) {
    if (t.is_infinite(t.cell_of(h))) h = t.twin(h);
    return {t.site(t.ccw(h)), t.site(t.cw(h)), t.site(h)};
}

/// The corners that face corner `slot` of a tetrahedron. With that corner last, the four are in positive order.
inline constexpr std::array<std::array<int, 3>, 4> facing_corners{{{2, 1, 3}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}}};

/// The vertices of half-facet h, turning left as seen from its own corner, then that corner.
[[nodiscard]] inline Cell_sites<3> facet_and_vertex(const Corner_table<3>& t, Corner_index h) {
    Cell_sites<3> x{};
    for (std::size_t k = 0; k < 3; ++k)
        x[k] = t.site(t.corner(t.cell_of(h), facing_corners[static_cast<std::size_t>(t.slot_of(h))][k]));
    x[3] = t.site(h);
    return x;
}
[[nodiscard]] inline Cell_sites<3> slab_sites(const Corner_table<3>& t, Corner_index h) {
    return facet_and_vertex(t, t.is_infinite(t.cell_of(h)) ? t.twin(h) : h);
}

/// Permutes the points of a ridge (an edge of the hull in 3D, a vertex in 2D) evenly: in 3D the two vertices of the
/// ridge come first, in 2D its one vertex comes last. `own` is the corner of the infinite cell opposite to the ridge,
/// `beyond` that of the other cell.
[[nodiscard]] inline Cell_sites<2> ridge_in_order(Cell_sites<2> x, Site<2> own, Site<2> beyond) {
    while (x[2] == own || x[2] == beyond) x = {x[1], x[2], x[0]};
    return x;
}
[[nodiscard]] inline Cell_sites<3> ridge_in_order(Cell_sites<3> x, Site<3> own, Site<3> beyond) {
    // Rotates three places at a time, which is an even permutation.
    const auto bring = [&x](Site<3> s, std::size_t to) {
        const auto from = static_cast<std::size_t>(std::find(x.begin(), x.end(), s) - x.begin());
        if (from == to) return;
        const std::size_t third = from == 0 || to == 0 ? (from == 1 || to == 1 ? 2U : 1U) : 0U;
        std::swap(x[from], x[to]);
        std::swap(x[from], x[third]);
    };
    bring(beyond, 3);
    bring(own, 2);
    return x;
}
template <int d>
[[nodiscard]] Cell_sites<d> ridge_vertex_last(const Corner_table<d>& t, Corner_index h, const Cell_sites<d>& x) {
    return ridge_in_order(x, t.site(h), t.opposite(h));
}

/// The points {a, b, p, q} of the bi-cell at half-facet h: q = site(h) is left of ab, p right of it.
[[nodiscard]] inline Facet_sites<2> bicell_sites(const Corner_table<2>& t, Corner_index h) {
    return {t.site(t.ccw(h)), t.site(t.cw(h)), t.opposite(h), t.site(h)};
}

/// The points {a, b, c, p, q} of the bi-cell at half-facet h, in the order of the predicates: q = site(h).
[[nodiscard]] inline Facet_sites<3> bicell_sites(const Corner_table<3>& t, Corner_index h) {
    const Cell_sites<3> x = facet_and_vertex(t, h);
    return {x[0], x[1], x[2], t.opposite(h), x[3]};
}

/// The certificate that a facet owns. `point` is padded with `none`; it is empty for a border.
template <int d>
struct Facet_certificate {
    Facet_kind kind;
    Facet_sites<d> point;
};

/// The certificate of half-facet h. With `slabs`, a border facet owns the paper's slab.
template <int d>
[[nodiscard]] Facet_certificate<d> facet_certificate(const Corner_table<d>& t, Corner_index h, bool slabs) {
    Facet_certificate<d> f{facet_kind(t, h), {}};
    if (f.kind == Facet_kind::empty_sphere) {
        f.point = bicell_sites(t, h);
        return f;
    }
    f.point.fill(Site<d>(none));
    if (f.kind == Facet_kind::nothing && slabs) f.kind = Facet_kind::slab;
    if (f.kind == Facet_kind::nothing) return f;
    const Cell_sites<d> x = f.kind == Facet_kind::ridge ? ridge_vertex_last(t, h, ridge_sites(t, h)) : slab_sites(t, h);
    std::copy(x.begin(), x.end(), f.point.begin());
    return f;
}

/// The certificate of the facet opposite to corner `slot` of a cell with these corners. `beyond` is the corner
/// opposite to it in the other cell.
[[nodiscard]] inline Facet_sites<2> bicell_sites(const Cell_sites<2>& cell, std::size_t slot, Site<2> beyond) {
    return {cell[(slot + 1) % 3], cell[(slot + 2) % 3], beyond, cell[slot]};
}
[[nodiscard]] inline Facet_sites<3> bicell_sites(const Cell_sites<3>& cell, std::size_t slot, Site<3> beyond) {
    const auto& facing = facing_corners[slot];
    return {cell[static_cast<std::size_t>(facing[0])], cell[static_cast<std::size_t>(facing[1])],
            cell[static_cast<std::size_t>(facing[2])], beyond, cell[slot]};
}
template <int d>
[[nodiscard]] Facet_certificate<d> facet_certificate(const Cell_sites<d>& cell, std::size_t slot, Site<d> beyond) {
    if (cell[slot].vertex == infinite || beyond.vertex == infinite) {
        Facet_certificate<d> f{Facet_kind::nothing, {}};
        f.point.fill(Site<d>(none));
        return f;
    }
    if (std::none_of(cell.begin(), cell.end(), [](Site<d> s) { return s.vertex == infinite; }))
        return {Facet_kind::empty_sphere, bicell_sites(cell, slot, beyond)};
    Facet_certificate<d> f{Facet_kind::ridge, {}};
    f.point.fill(Site<d>(none));
    const Cell_sites<d> x = ridge_in_order(ridge_sites<d>(cell, beyond), cell[slot], beyond);
    std::copy(x.begin(), x.end(), f.point.begin());
    return f;
}

/// Pointers to the positions in x of the first k points.
template <int d, std::size_t k, std::size_t n>
requires(k <= n) [[nodiscard]] Tuple<d, static_cast<int>(k)> tuple(const std::array<Site<d>, n>& point,
                                                                   std::span<const Coordinates<d>> x) {
    Tuple<d, static_cast<int>(k)> t{};
    for (std::size_t i = 0; i < k; ++i) t[i] = &x[static_cast<std::size_t>(point[i].vertex)];
    return t;
}

/// Visits every certificate that contains v. Calls on_cell(h) with the corner of v in each of its cells, then, for
/// that cell, on_facet(k) with a half-facet of each facet whose bi-cell contains v, each once. O(degree).
template <class On_cell, class On_facet>
void for_each_certificate(const Corner_table<2>& t, Index v, On_cell on_cell, On_facet on_facet) {
    t.for_each_corner(v, [&](Corner_index h) {
        on_cell(h);
        on_facet(h);
        on_facet(t.ccw(h));
    });
}
template <class On_cell, class On_facet>
void for_each_certificate(const Corner_table<3>& t, Index v, On_cell on_cell, On_facet on_facet) {
    t.for_each_corner(v, [&](Corner_index h) {
        on_cell(h);
        on_facet(h);
        for (int i = 0; i <= 3; ++i) {  // the other three contain v and are seen from two of its cells
            const Corner_index k = t.corner(t.cell_of(h), i);
            if (k != h && k < t.twin(k)) on_facet(k);
        }
    });
}

}  // namespace annulus::inline v1
