// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/degeneracy.h>

namespace annulus::inline v1 {

/// What degeneracy() of a Periodic_mesh counts. Preconditions: `mesh` is the Delaunay triangulation of its points, one
/// at least, with neighbours and translations; points and box are multiples of the powers of two `grid`.
template <int d>
[[nodiscard]] Degeneracy periodic_degeneracy(const Periodic_audit_input<d>& mesh, const Coordinates<d>& grid,
                                             const Degeneracy_options<d>& options);

extern template Degeneracy periodic_degeneracy(const Periodic_audit_input<2>&, const Coordinates<2>&,
                                               const Degeneracy_options<2>&);
extern template Degeneracy periodic_degeneracy(const Periodic_audit_input<3>&, const Coordinates<3>&,
                                               const Degeneracy_options<3>&);

}  // namespace annulus::inline v1
