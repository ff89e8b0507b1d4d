// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <concepts>
#include <cstdint>

namespace annulus::inline v1 {

/// What Cgal_view uses of CGAL's triangulation `Dt`: CGAL::Delaunay_triangulation_2 or _3 over CGAL's kernel Epick
/// (Exact_predicates_inexact_constructions_kernel), with any triangulation data structure.
template <class Dt>
struct Cgal_traits;

/// A vertex or cell base that stores a number of the library's own (types_2.h, types_3.h). Others need a table.
template <class Element>
concept Has_number = requires {
    typename Element::Annulus_number;
};

/// A vertex that carries data of the caller's, by CGAL's name.
template <class Vertex>
concept Has_info = requires(Vertex& v) {
    v.info();
};

/// A triangulation of CGAL's in the dimension of `Dt`, to read vertices of.
template <class Other, class Dt>
concept Similar_triangulation = requires(const Other& t) {
    t.finite_vertices_begin();
    t.finite_vertices_end();
    { t.finite_vertices_begin()->point() } -> std::convertible_to<typename Dt::Point>;
};

}  // namespace annulus::inline v1
