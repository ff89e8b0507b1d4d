// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace annulus::inline v1 {

/// Of a picture with more Voronoi cells than this a window with about `faces_in_window` is shown: a face takes three
/// times the bytes of an edge.
inline constexpr std::size_t most_faces = 4000;
inline constexpr std::size_t faces_in_window = 2500;

}  // namespace annulus::inline v1
