// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/rebuilt_delaunay_3.h>

namespace annulus::cli {

/// The triangulation of space that runs follow.
using Moving_3 = Rebuilt_delaunay_3;

}  // namespace annulus::cli
