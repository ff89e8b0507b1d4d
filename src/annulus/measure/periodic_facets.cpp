// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_facets.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace annulus::inline v1 {

namespace {

template <int d>
Coordinates<d> difference(const Coordinates<d>& a, const Coordinates<d>& b, double scale) {
    Coordinates<d> out;
    for (std::size_t k = 0; k < d; ++k) out[k] = (a[k] - b[k]) * scale;
    return out;
}

}  // namespace

/// Image `from` is the point 0, `to` the point 1, and each cell has points of its own for its other corners.
template <int d>
Facet_measure<d> Periodic_facets<d>::measured_exactly(const Periodic_ring<d>& ring) const {
    std::vector<Coordinates<d>> points{places_.at(ring.from), places_.at(ring.to)};
    Mesh_cells<d> cells;
    for (const auto& [number, shift] : ring.cells) {
        auto& corners = cells.vertices.emplace_back();
        for (std::size_t k = 0; k <= d; ++k) {
            const Image<d> corner = table_.image(number, k, shift);
            corners[k] = corner == ring.from ? 0 : static_cast<Index>(points.size());
            if (corners[k] != 0) points.push_back(places_.at(corner));
        }
    }
    std::vector<Index> all(ring.cells.size());
    std::iota(all.begin(), all.end(), Index{0});
    return exact_facet<d>(points, cells, 0, 1, all);
}

template <int d>
Periodic_facet<d> Periodic_facets<d>::facet_of(const Periodic_ring<d>& ring) const {
    Periodic_facet<d> facet;
    facet.i = ring.from.vertex;
    facet.j = ring.to.vertex;
    facet.exponent = places_.exponent();
    facet.empty = ring.empty;
    const Coordinates<d> here = places_.at(ring.from);
    facet.vector = difference<d>(places_.at(ring.to), here, 1);
    if constexpr (d == 2) facet.distance = std::hypot(facet.vector[0], facet.vector[1]);
    else facet.distance = std::hypot(facet.vector[0], facet.vector[1], facet.vector[2]);
    if (ring.empty) return facet;
    const auto seen = [&](std::size_t k) {
        const auto& [number, shift] = ring.cells[k];
        const Image<d> base = table_.image(number, 0, shift);
        const Circumcentre<d>& centre = places_.centres()[number];
        if (base == ring.from) return Seen_centre<d>{centre.offset, centre.error};
        return seen_centre<d>(difference<d>(places_.at(base), here, places_.scale()), centre);
    };
    const Coordinates<d> edge = difference<d>(places_.at(ring.to), here, places_.scale());
    if (!measure_facet<d>(edge, ring.cells.size(), seen, facet))
        static_cast<Facet_measure<d>&>(facet) = measured_exactly(ring);
    return facet;
}

template class Periodic_facets<2>;
template class Periodic_facets<3>;

}  // namespace annulus::inline v1
