// SPDX-License-Identifier: GPL-3.0-or-later
// The one translation unit of the library that compiles CGAL's 2D triangulation for callers without vertex info.
#include <annulus/moving_delaunay_2.h>

namespace annulus::inline v1 {

template class Cgal_view<Cgal_traits_2<No_info>>;
template class Moving_delaunay<Delaunay_2<No_info>>;

}  // namespace annulus::inline v1
