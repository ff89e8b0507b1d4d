// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cells_3.h>
#include <apps/report/svg_triangulation.h>

#include <span>
#include <string>

namespace annulus::inline v1 {

/// The cells with a flag, cut by the plane x[axis] = at: the outlines of their sections, seen along the axis.
/// Vertices on the plane count as above it. The other two axes run right and up, in their order. `filled`: the sections
/// are faces, with the shade of the least dihedral angle of their cell. Linear.
[[nodiscard]] Picture cut_picture(const Mesh_cells<3>& cells, std::span<const char> inside,
                                  std::span<const Coordinates<3>> position, std::size_t axis, double at,
                                  std::string caption, bool filled = false);

}  // namespace annulus::inline v1
