// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cgal/embedding.h>
#include <annulus/cgal/traits_3.h>

namespace annulus {

template <class Info>
using Cgal_embedding_3 = Cgal_embedding<Cgal_traits_3<Info>>;

}  // namespace annulus
