// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "stopwatch.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace bench {

/// The time of CGAL's rebuild: insertion of a range, with the input order as the only info at its vertices. Making the
/// pairs beforehand and destroying the object afterwards are not counted.
template <int d>
double cgal_rebuild(const Points<d>& x, Stopwatch watch) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Point = std::conditional_t<d == 2, typename Kernel::Point_2, typename Kernel::Point_3>;
    std::vector<std::pair<Point, Index>> points;
    points.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        if constexpr (d == 2) points.emplace_back(Point(x[i][0], x[i][1]), static_cast<Index>(i));
        else points.emplace_back(Point(x[i][0], x[i][1], x[i][2]), static_cast<Index>(i));
    }
    if constexpr (d == 2) {
        using Vb = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
        const double begin = watch.seconds();
        CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vb>> tr(points.begin(),
                                                                                            points.end());
        return watch.seconds() - begin;
    } else {
        using Vb = CGAL::Triangulation_vertex_base_with_info_3<Index, Kernel>;
        using Tds = CGAL::Triangulation_data_structure_3<Vb, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
        const double begin = watch.seconds();
        CGAL::Delaunay_triangulation_3<Kernel, Tds> tr(points.begin(), points.end());
        return watch.seconds() - begin;
    }
}

}  // namespace bench
