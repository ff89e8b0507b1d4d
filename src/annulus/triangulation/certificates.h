// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/certificate/ladder.h>
#include <annulus/triangulation/cell_table.h>

#include <utility>

namespace annulus {

/// The three kinds of certificate a facet of T can own (theory 1); the fourth, the orientation of a finite cell,
/// belongs to the cell.
enum class Facet_kind : std::uint8_t {
    empty_sphere,  ///< both cells finite
    border,        ///< one infinite cell: nothing beyond the orientation of the finite one
    ridge,         ///< both cells infinite: the hull is convex there
    slab,          ///< the paper's view of a border facet: its own parallel hyperplanes (kind `paper` only)
};

/// Points of a certificate as vertex indices; a ridge leaves the last entry `none`.
template <int d>
using Facet_points = std::array<Index, static_cast<std::size_t>(d + 2)>;
template <int d>
using Cell_points = std::array<Index, static_cast<std::size_t>(d + 1)>;

template <int d>
[[nodiscard]] Facet_kind facet_kind(const Cell_table<d>& t, Index h) {
    const bool one = t.is_infinite(t.cell_of(h));
    const bool other = t.is_infinite(t.cell_of(t.twin(h)));
    return one && other ? Facet_kind::ridge : one || other ? Facet_kind::border : Facet_kind::empty_sphere;
}

/// The points of a finite cell in positive order.
template <int d>
[[nodiscard]] Cell_points<d> cell_points(const Cell_table<d>& t, Index c) {
    Cell_points<d> x{};
    for (int i = 0; i <= d; ++i) x[static_cast<std::size_t>(i)] = t.vertex(t.corner(c, i));
    return x;
}

/// The points of a ridge, ordered so that their orientation is positive where the hull is strictly convex: the
/// infinite cell of h with infinity replaced by the vertex opposite in the other cell, and two points swapped (an
/// infinite cell lies outside).
template <int d>
[[nodiscard]] Cell_points<d> ridge_points(const Cell_table<d>& t, Index h) {
    Cell_points<d> x = cell_points(t, t.cell_of(h));
    for (Index& v : x)
        if (v == infinite) v = t.vertex(t.twin(h));
    std::swap(x[0], x[1]);
    return x;
}

/// The points of a border facet for the paper's slab: its finite cell in positive order, the vertex off the facet last.
[[nodiscard]] inline Cell_points<2> slab_points(const Cell_table<2>& t, Index h) {
    if (t.is_infinite(t.cell_of(h))) h = t.twin(h);
    return {t.vertex(t.ccw(h)), t.vertex(t.cw(h)), t.vertex(h)};
}

/// Turns the points of a ridge so that its own finite vertex comes last.
[[nodiscard]] inline Cell_points<2> ridge_vertex_last(const Cell_table<2>& t, Index h, Cell_points<2> x) {
    const Index v = t.vertex(t.ccw(h)) == infinite ? t.vertex(t.cw(h)) : t.vertex(t.ccw(h));
    while (x[2] != v) x = {x[1], x[2], x[0]};
    return x;
}

/// The points {a, b, p, q} of the bi-cell at half-facet h: q = vertex(h) is left of ab, p right of it.
[[nodiscard]] inline Facet_points<2> bicell_points(const Cell_table<2>& t, Index h) {
    return {t.vertex(t.ccw(h)), t.vertex(t.cw(h)), t.vertex(t.twin(h)), t.vertex(h)};
}

}  // namespace annulus
