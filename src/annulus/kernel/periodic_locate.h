// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>
#include <annulus/mesh/replace_periodic_cells.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <optional>
#include <span>

namespace annulus::inline v1 {

// Which cell of a periodic Delaunay triangulation contains a point: `shift` is the offset of p as that cell sees it.
// Exact. p is a representative (Lattice), the table has cells, and is proved for these places.

/// By a walk from one of a few cells, expected O(n^(1/(d + 1))) for points that are spread evenly. Nothing where it
/// goes too far for places to be exact: in boxes that are much longer than wide.
template <int d>
[[nodiscard]] std::optional<Lifted_cell<d>> walk_to(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                                    std::span<const Coordinates<d>> place, const Coordinates<d>& p);

/// The same, and where the walk goes too far by testing all cells.
template <int d>
[[nodiscard]] Lifted_cell<d> locate(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                    std::span<const Coordinates<d>> place, const Coordinates<d>& p);

/// By testing all cells, O(n) with a large constant.
template <int d>
[[nodiscard]] Lifted_cell<d> search_for(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                        std::span<const Coordinates<d>> place, const Coordinates<d>& p);

/// Whether places with this offset are exact (Lattice).
template <int d>
[[nodiscard]] bool is_near(Offset<d> o) {
    constexpr std::int32_t most = 8;
    for (const std::int32_t c : o.unpacked())
        if (c < -most || c > most) return false;
    return true;
}

extern template std::optional<Lifted_cell<2>> walk_to(const Periodic_table<2>&, const Lattice<2>&,
                                                      std::span<const Coordinates<2>>, const Coordinates<2>&);
extern template std::optional<Lifted_cell<3>> walk_to(const Periodic_table<3>&, const Lattice<3>&,
                                                      std::span<const Coordinates<3>>, const Coordinates<3>&);
extern template Lifted_cell<2> locate(const Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                                      const Coordinates<2>&);
extern template Lifted_cell<3> locate(const Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                                      const Coordinates<3>&);
extern template Lifted_cell<2> search_for(const Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                                          const Coordinates<2>&);
extern template Lifted_cell<3> search_for(const Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                                          const Coordinates<3>&);

}  // namespace annulus::inline v1
