// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/traits_3.h>
#include <annulus/internal/view.h>

namespace annulus::inline v1 {

template <class Info>
using Cgal_view_3 = Cgal_view<Cgal_traits_3<Info>>;

}  // namespace annulus::inline v1
