// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/edge_rings.h>
#include <annulus/measure/facet_measure.h>
#include <annulus/measure/voronoi_facet_exact.h>
#include <annulus/measure/voronoi_input.h>
#include <annulus/space/euclidean.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The facet between the Voronoi cells of two neighbours.
template <int d>
struct Voronoi_facet : Facet_measure<d> {
    Index i = 0, j = 0;             ///< i < j
    bool bounded = true;            ///< otherwise the measure is infinite, and the centroid NaN
    bool empty = false;             ///< exactly: the measure is 0, the centroid NaN
    double distance = 0;            ///< of i and j, in the caller's unit
    Coordinates<d> vector{};        ///< from i to j, in the caller's unit
    std::span<const Index> ring{};  ///< the cells around the edge, as Edge_ring has them
};

/// Circumcentres of an earlier list of cells.
template <int d>
struct Known_circumcentres {
    std::span<const Index> before;            ///< by cell: its number there; `none` if it is not what it was
    std::span<const Circumcentre<d>> centre;  ///< by number there, in the unit 2^exponent
    int exponent;
};

/// Computes all facets of the Voronoi diagram of a Delaunay triangulation.
template <int d>
class Voronoi_facets {
  public:
    /// Refers to both. What is known is taken, if it is in the same unit. Throws as voronoi_volumes does.
    Voronoi_facets(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                   const Known_circumcentres<d>* known = nullptr);

    /// Calls visit(Voronoi_facet<d>) for each edge, in an order that depends on the cells alone. Where the points do
    /// not span d dimensions every facet is unbounded, and has no ring.
    template <class Visit>
    void for_each(Visit visit) {
        if (!input_.spans) {
            for (const auto& [i, j] : flat_edges()) visit(facet_of(Edge_ring{i, j, {}, {}, true}));
            return;
        }
        Edge_rings<d>(input_.cells).for_each([&](const Edge_ring& ring) { visit(facet_of(ring)); });
    }

    /// The same, in the same order, for some edges: see Edge_rings. Precondition: the points span d dimensions.
    template <class Wanted, class Visit>
    void for_each_of(std::span<const Index> cells, Wanted wanted, Visit visit) {
        Edge_rings<d>(input_.cells).for_each_of(cells, wanted, [&](const Edge_ring& r) { visit(facet_of(r)); });
    }

    /// Whether a cell and the one beyond its facet opposite to corner k have exactly the same circumcentre.
    [[nodiscard]] bool is_cospherical(Index c, std::size_t k);

    /// The Voronoi vertex of a cell, in the caller's unit.
    [[nodiscard]] Coordinates<d> vertex(Index c) const;

    /// Every coordinate is below 2^exponent, the unit of circumcentres and of most facets.
    [[nodiscard]] int exponent() const { return exponent_; }
    [[nodiscard]] const Voronoi_input<d>& input() const { return input_; }
    /// By cell.
    [[nodiscard]] std::span<const Circumcentre<d>> centres() const { return centre_; }
    [[nodiscard]] std::vector<Circumcentre<d>> take_centres() { return std::move(centre_); }

  private:
    enum class Verdict : char { unknown, same, different };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    /// (b - a) in the unit, each coordinate with a relative error of u at most.
    [[nodiscard]] Coordinates<d> difference(Index a, Index b) const {
        return Euclidean<d>::difference(input_.points[at(b)], input_.points[at(a)],
                                        [this](double p, double q) { return (p - q) * scale_; });
    }
    [[nodiscard]] Seen_centre<d> seen_from(Index a, Index c) const {
        const Index base = input_.cells.vertices[at(c)][0];
        const Circumcentre<d>& centre = centre_[at(c)];
        if (base == a) return {centre.offset, centre.error};
        return seen_centre<d>(difference(a, base), centre);
    }
    [[nodiscard]] std::vector<std::array<Index, 2>> flat_edges() const;
    [[nodiscard]] Voronoi_facet<d> facet_of(const Edge_ring& ring);
    [[nodiscard]] bool is_empty(const Edge_ring& ring);
    [[nodiscard]] bool is_flat_hull(const Edge_ring& ring) const;
    void note_edge(Voronoi_facet<d>& facet) const;
    /// In doubles; false where these are not accurate enough.
    [[nodiscard]] bool measure(Voronoi_facet<d>& facet) const;

    Voronoi_input<d> input_;
    int exponent_;  // of the unit: every coordinate is below 2^exponent
    double scale_;  // 2^-exponent
    std::vector<Circumcentre<d>> centre_;
    std::vector<Verdict> verdict_;  // by facet of a cell; made by the first call of is_cospherical
};

template <int d>
void Voronoi_facets<d>::note_edge(Voronoi_facet<d>& facet) const {
    const Coordinates<d> e = difference(facet.i, facet.j);
    double square = e[0] * e[0];
    for (std::size_t k = 1; k < d; ++k) square += e[k] * e[k];
    const auto& p = input_.points[at(facet.i)];
    const auto& q = input_.points[at(facet.j)];
    for (std::size_t k = 0; k < d; ++k) facet.vector[k] = q[k] - p[k];
    if (square > 0x1p-800 && square < 64) facet.distance = std::ldexp(std::sqrt(square), exponent_);
    else if constexpr (d == 2) facet.distance = std::hypot(facet.vector[0], facet.vector[1]);
    else facet.distance = std::hypot(facet.vector[0], facet.vector[1], facet.vector[2]);
}

template <int d>
bool Voronoi_facets<d>::measure(Voronoi_facet<d>& facet) const {
    facet.exponent = exponent_;
    const Coordinates<d> e = d == 2 ? Coordinates<d>{} : difference(facet.i, facet.j);
    return measure_facet<d>(
        e, facet.ring.size(), [&](std::size_t k) { return seen_from(facet.i, facet.ring[k]); }, facet);
}

extern template class Voronoi_facets<2>;
extern template class Voronoi_facets<3>;

}  // namespace annulus::inline v1
