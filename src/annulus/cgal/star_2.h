// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/certificate/ladder.h>
#include <annulus/certificate/theta.h>
#include <annulus/cgal/types_2.h>

#include <algorithm>
#include <array>
#include <limits>

namespace annulus::cgal_2 {

// The certificates of CGAL's object at CGAL's points, and those of one vertex. Nothing here needs the mirror.

template <class Vertex_handle>
[[nodiscard]] Coordinates<2> coordinates(Vertex_handle v) {
    return {v->point().x(), v->point().y()};
}

/// The orientation of a face; positive where it is infinite.
template <class Tr>
[[nodiscard]] Verdict face_verdict(const Tr& tr, typename Tr::Face_handle f) {
    if (tr.is_infinite(f)) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    const std::array<Coordinates<2>, 3> x{coordinates(f->vertex(0)), coordinates(f->vertex(1)),
                                          coordinates(f->vertex(2))};
    return orientation_verdict({&x[0], &x[1], &x[2]});
}

/// The verdict of the edge (f, i), with the perturbation deciding cocircular points; positive where it has no
/// certificate of its own.
template <class Tr>
[[nodiscard]] Verdict edge_verdict(const Tr& tr, typename Tr::Face_handle f, int i) {
    const auto g = f->neighbor(i);
    const auto vp = g->vertex(tr.tds().mirror_index(f, i));
    const bool f_infinite = tr.is_infinite(f);
    if (f_infinite != tr.is_infinite(g)) return {std::numeric_limits<double>::infinity(), 1, Stage::filter};
    const auto va = f->vertex(tr.ccw(i));
    const auto vb = f->vertex(tr.cw(i));
    const Coordinates<2> a = coordinates(tr.is_infinite(va) ? vp : va);
    const Coordinates<2> b = coordinates(tr.is_infinite(vb) ? vp : vb);
    const Coordinates<2> q = coordinates(f->vertex(i));
    if (f_infinite) {  // infinity replaced by the vertex across: the hull is convex when this turns right or not at all
        Verdict out = orientation_verdict({&b, &a, &q});
        if (out.sign == 0) out.sign = 1;
        return out;
    }
    const Coordinates<2> p = coordinates(vp);
    const Tuple<2, 4> bicell{&a, &b, &p, &q};
    Verdict out = empty_sphere_verdict(bicell);
    if (out.sign == 0) out.sign = static_cast<std::int8_t>(perturbed_empty_circle_sign(bicell));
    return out;
}

/// Theta of the edge (f, i), whose faces are finite.
template <class Tr>
[[nodiscard]] double edge_theta(const Tr& tr, typename Tr::Face_handle f, int i) {
    return theta(coordinates(f->vertex(tr.ccw(i))), coordinates(f->vertex(tr.cw(i))),
                 coordinates(tr.tds().mirror_vertex(f, i)), coordinates(f->vertex(i)));
}

/// Has the edge (f, i) a finite face on both sides?
template <class Tr>
[[nodiscard]] bool finite_bicell(const Tr& tr, typename Tr::Face_handle f, int i) {
    return !tr.is_infinite(f) && !tr.is_infinite(f->neighbor(i));
}

/// Visits every face at v. Precondition, here and below: dimension 2.
template <class Tr, class Visit>
void for_each_face_around(const Tr& tr, typename Tr::Vertex_handle v, Visit visit) {
    auto f = tr.incident_faces(v);
    const auto done = f;
    do visit(typename Tr::Face_handle(f));
    while (++f != done);
}

/// Visits (face, i) for every edge whose bi-cell contains v: the spokes and the link.
template <class Tr, class Visit>
void for_each_edge_around(const Tr& tr, typename Tr::Vertex_handle v, Visit visit) {
    for_each_face_around(tr, v, [&](typename Tr::Face_handle f) {
        const int i = f->index(v);
        visit(f, i);
        visit(f, tr.ccw(i));
    });
}

/// Exact test of every certificate that contains v.
template <class Tr>
[[nodiscard]] bool star_holds(const Tr& tr, typename Tr::Vertex_handle v) {
    using Face_handle = typename Tr::Face_handle;
    bool holds = true;
    for_each_face_around(tr, v, [&](Face_handle f) { holds = holds && face_verdict(tr, f).sign > 0; });
    if (!holds) return false;
    for_each_edge_around(tr, v, [&](Face_handle f, int i) { holds = holds && edge_verdict(tr, f, i).sign > 0; });
    return holds;
}

/// Least tolerance of the certificates of v, certified.
template <class Tr>
[[nodiscard]] double star_tolerance(const Tr& tr, typename Tr::Vertex_handle v) {
    using Face_handle = typename Tr::Face_handle;
    double least = std::numeric_limits<double>::infinity();
    for_each_face_around(tr, v, [&](Face_handle f) { least = std::min(least, face_verdict(tr, f).tolerance); });
    for_each_edge_around(tr, v,
                         [&](Face_handle f, int i) { least = std::min(least, edge_verdict(tr, f, i).tolerance); });
    return least;
}

/// Least theta of the finite bi-cells that contain v; pi/2 when there is none, also where the points are flat.
template <class Tr>
[[nodiscard]] double star_theta(const Tr& tr, typename Tr::Vertex_handle v) {
    double least = 1.5707963267948966;  // pi / 2
    if (tr.dimension() != 2) return least;
    for_each_edge_around(tr, v, [&](typename Tr::Face_handle f, int i) {
        if (finite_bicell(tr, f, i)) least = std::min(least, edge_theta(tr, f, i));
    });
    return least;
}

}  // namespace annulus::cgal_2
