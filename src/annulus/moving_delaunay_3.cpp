// SPDX-License-Identifier: GPL-3.0-or-later
// The one translation unit of the library that compiles CGAL's 3D triangulation for callers without vertex info.
#include <annulus/moving_delaunay_3.h>

namespace annulus::inline v1 {

template class Cgal_view<Cgal_traits_3<No_info>>;
template class Moving_delaunay<Delaunay_3<No_info>>;

}  // namespace annulus::inline v1
