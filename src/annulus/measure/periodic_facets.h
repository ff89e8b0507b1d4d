// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/facet_measure.h>
#include <annulus/measure/periodic_places.h>
#include <annulus/measure/periodic_rings.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// The facet between the Voronoi cells of two neighbouring images, with the names of Voronoi_facet.
template <int d>
struct Periodic_facet : Facet_measure<d> {
    static constexpr bool bounded = true;
    Index i = 0, j = 0;       ///< may be the same vertex
    bool empty = false;       ///< exactly: measure and centroid are 0
    double distance = 0;      ///< of the image of i and that of j, in the caller's unit
    Coordinates<d> vector{};  ///< from i to j, in the caller's unit
};

/// Computes all facets of a periodic Voronoi diagram, with the accuracy of Voronoi_facets: a relative error of
/// voronoi_diagram_error (voronoi.h), in integers where doubles are not accurate enough.
template <int d>
class Periodic_facets {
  public:
    /// Refers to all three.
    Periodic_facets(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place)
        : table_(table), places_(table, lattice, place) {}

    /// Calls visit(Periodic_facet<d>) for each edge, in an order that depends on the table alone.
    template <class Visit>
    void for_each(Visit visit) {
        Periodic_rings<d>(table_).for_each([&](const Periodic_ring<d>& ring) { visit(facet_of(ring)); });
    }

    /// The facet of one edge, as seen from its first end.
    [[nodiscard]] Periodic_facet<d> facet_of(const Periodic_ring<d>& ring) const;

    /// Of the unit of most facets.
    [[nodiscard]] int exponent() const { return places_.exponent(); }
    [[nodiscard]] const Periodic_places<d>& places() const { return places_; }

  private:
    [[nodiscard]] Facet_measure<d> measured_exactly(const Periodic_ring<d>& ring) const;

    const Periodic_table<d>& table_;
    Periodic_places<d> places_;
};

extern template class Periodic_facets<2>;
extern template class Periodic_facets<3>;

}  // namespace annulus::inline v1
