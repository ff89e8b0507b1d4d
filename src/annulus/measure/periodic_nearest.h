// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>
#include <annulus/mesh/replace_periodic_cells.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// A corner of a lifted cell.
template <int d>
struct Lifted_corner {
    Lifted_cell<d> at;
    std::size_t slot;
};

/// The image of a vertex that is nearest to p, as a corner; of several, any of them. Exact: a walk from neighbour to
/// neighbour, each nearer than the last one. It begins at the corners of `start`, which contains p
/// (kernel/periodic_locate.h): O(1) expected. A walk that goes too far for places to be exact is given up, and all
/// vertices are compared; in a million walks in boxes of all kinds none was. Preconditions: p is a representative
/// (Lattice), the table is proved for these places, rounding is to nearest.
template <int d>
[[nodiscard]] Lifted_corner<d> nearest_corner(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                              std::span<const Coordinates<d>> place, const Coordinates<d>& p,
                                              Lifted_cell<d> start);

/// A corner at which this image is. Precondition: the vertex is in a cell. O(n).
template <int d>
[[nodiscard]] Lifted_corner<d> corner_at(const Periodic_table<d>& table, Image<d> image);

/// The nearest image by comparing all vertices, O(n) with a large constant; `none` without any.
template <int d>
[[nodiscard]] Image<d> nearest_of_all(const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                                      const Coordinates<d>& p);

extern template Lifted_corner<2> nearest_corner(const Periodic_table<2>&, const Lattice<2>&,
                                                std::span<const Coordinates<2>>, const Coordinates<2>&, Lifted_cell<2>);
extern template Lifted_corner<3> nearest_corner(const Periodic_table<3>&, const Lattice<3>&,
                                                std::span<const Coordinates<3>>, const Coordinates<3>&, Lifted_cell<3>);
extern template Lifted_corner<2> corner_at(const Periodic_table<2>&, Image<2>);
extern template Lifted_corner<3> corner_at(const Periodic_table<3>&, Image<3>);
extern template Image<2> nearest_of_all(const Lattice<2>&, std::span<const Coordinates<2>>, const Coordinates<2>&);
extern template Image<3> nearest_of_all(const Lattice<3>&, std::span<const Coordinates<3>>, const Coordinates<3>&);

}  // namespace annulus::inline v1
