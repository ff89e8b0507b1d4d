// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>
#include <annulus/internal/no_info.h>
#include <annulus/types.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <type_traits>

namespace annulus::inline v1 {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// CGAL's vertex with the caller's info and the index in input order.
template <class Info, class Gt, class Vb = CGAL::Triangulation_vertex_base_with_info_2<Info, Gt>>
class Indexed_vertex_base_2 : public Vb {
    // When a constructor throws, CGAL's containers treat the element as constructed.
    static_assert(std::is_nothrow_default_constructible_v<Info>, "the default constructor of Info must be noexcept");

  public:
    using Annulus_number = Index;
    using Face_handle = typename Vb::Face_handle;
    using Point = typename Vb::Point;
    template <class TDS2>
    struct Rebind_TDS {
        using Vb2 = typename Vb::template Rebind_TDS<TDS2>::Other;
        using Other = Indexed_vertex_base_2<Info, Gt, Vb2>;
    };
    using Vb::Vb;
    [[nodiscard]] Index index() const { return index_; }
    void set_index(Index i) { index_ = i; }

  private:
    Index index_ = none;
};

/// CGAL's face with the number of its cell in the mesh (Cell_index::value).
template <class Gt, class Fb = CGAL::Triangulation_face_base_2<Gt>>
class Indexed_face_base_2 : public Fb {
  public:
    using Annulus_number = Index;
    template <class TDS2>
    struct Rebind_TDS {
        using Fb2 = typename Fb::template Rebind_TDS<TDS2>::Other;
        using Other = Indexed_face_base_2<Gt, Fb2>;
    };
    using Fb::Fb;
    [[nodiscard]] Index cell() const { return cell_; }
    void set_cell(Index c) { cell_ = c; }

  private:
    Index cell_ = no_cell.value();
};

template <class Info>
using Delaunay_2 = CGAL::Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Indexed_vertex_base_2<Info, Kernel>, Indexed_face_base_2<Kernel>>>;

}  // namespace annulus::inline v1
