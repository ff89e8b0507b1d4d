// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/degeneracy.h>
#include <annulus/mesh/corner_table.h>

#include <span>

namespace annulus::inline v1 {

/// Precondition: t is a Delaunay triangulation of the points x, which are in the coordinate domain and span the
/// space. A bi-cell costs a microsecond, a degenerate one ten or more.
[[nodiscard]] Degeneracy degeneracy(const Corner_table<2>& t, std::span<const Coordinates<2>> x,
                                    const Degeneracy_options<2>& options = {});
[[nodiscard]] Degeneracy degeneracy(const Corner_table<3>& t, std::span<const Coordinates<3>> x,
                                    const Degeneracy_options<3>& options = {});

}  // namespace annulus::inline v1
