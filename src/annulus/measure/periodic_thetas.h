// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// By vertex the least theta (predicate/theta.h) of the bi-cells of its images, in radians; NaN where there is none.
/// O(n). Precondition: a proved table (kernel/periodic_proof.h).
template <int d>
[[nodiscard]] std::vector<double> periodic_thetas(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                                  std::span<const Coordinates<d>> place);

extern template std::vector<double> periodic_thetas(const Periodic_table<2>&, const Lattice<2>&,
                                                    std::span<const Coordinates<2>>);
extern template std::vector<double> periodic_thetas(const Periodic_table<3>&, const Lattice<3>&,
                                                    std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
