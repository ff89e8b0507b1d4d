// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/moving_delaunay.h>
#include <annulus/internal/view_2.h>

namespace annulus::inline v1 {

/// A moving Delaunay triangulation in 2D whose vertices carry the caller's Info: `dt.vertex(i)->info()`.
template <class Info>
using Moving_delaunay_with_info_2 = Moving_delaunay<Delaunay_2<Info>>;

/// A moving Delaunay triangulation in 2D.
using Moving_delaunay_2 = Moving_delaunay_with_info_2<No_info>;

extern template class Cgal_view<Cgal_traits_2<No_info>>;
extern template class Moving_delaunay<Delaunay_2<No_info>>;

}  // namespace annulus::inline v1
