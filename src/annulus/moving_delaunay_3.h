// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/moving_delaunay.h>
#include <annulus/internal/view_3.h>

namespace annulus::inline v1 {

/// A moving Delaunay triangulation in 3D whose vertices carry the caller's Info: `dt.vertex(i)->info()`.
template <class Info>
using Moving_delaunay_with_info_3 = Moving_delaunay<Delaunay_3<Info>>;

/// A moving Delaunay triangulation in 3D.
using Moving_delaunay_3 = Moving_delaunay_with_info_3<No_info>;

extern template class Cgal_view<Cgal_traits_3<No_info>>;
extern template class Moving_delaunay<Delaunay_3<No_info>>;

}  // namespace annulus::inline v1
