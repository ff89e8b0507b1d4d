// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/embedding.h>
#include <annulus/cgal/traits_2.h>

namespace annulus {

template <class Info>
using Cgal_embedding_2 = Cgal_embedding<Cgal_traits_2<Info>>;

}  // namespace annulus
