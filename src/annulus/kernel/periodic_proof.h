// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_journal.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// Whether a table is the Delaunay triangulation of the points at these places and their translates, by the theorem of
/// docs/theory.md 8.3: facets are glued in pairs, with opposite orientations and to the same images; every vertex has a
/// cell, but where its place is NaN; the volumes of the cells add up to that of the lattice; every cell is positive,
/// and no opposite vertex is inside the sphere of a bi-cell, where cospherical points are decided by the perturbation.
/// All of it is exact, so that `true` is a proof. Writes `cospherical`. By at most this many threads. O(n). Needs
/// rounding to nearest.
template <int d>
[[nodiscard]] bool is_proved_delaunay(Periodic_table<d>& table, const Lattice<d>& lattice,
                                      std::span<const Coordinates<d>> place, int threads = 1);

/// What was changed in a table.
template <int d>
struct Periodic_table_changes {
    const Periodic_journal<d>& journal;       ///< of all cells that were changed
    std::span<const Coordinates<d>> place;    ///< of the vertices, where offsets are those of the journal
    std::span<const std::size_t> unfinished;  ///< numbers of cells; more than there are do not count
};

/// The same for a table that was proved, of other places and perhaps another lattice, and has changed since: it
/// examines what was changed, which is a proof by Lemma 5 of docs/theory.md 8.7. Certificates of cells that were not
/// changed must have been tested at these places: those that do not hold are of cells that were changed or are named as
/// unfinished. `cospherical` must have an entry for each cell, right for facets between unchanged ones. Precondition: a
/// cell that was not changed is the same at both places, up to a translation. O(n), and the cost of changed cells.
template <int d>
[[nodiscard]] bool is_still_proved_delaunay(Periodic_table<d>& table, const Lattice<d>& lattice,
                                            std::span<const Coordinates<d>> place,
                                            const Periodic_table_changes<d>& changes);

extern template bool is_proved_delaunay(Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>, int);
extern template bool is_proved_delaunay(Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>, int);
extern template bool is_still_proved_delaunay(Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                                              const Periodic_table_changes<2>&);
extern template bool is_still_proved_delaunay(Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                                              const Periodic_table_changes<3>&);

}  // namespace annulus::inline v1
