// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/edge_rings.h>
#include <annulus/measure/voronoi_facet_exact.h>
#include <annulus/measure/voronoi_input.h>
#include <annulus/predicate/bounds.h>
#include <annulus/space/euclidean.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

// A facet between the Voronoi cells of i and j is the polygon of the circumcentres C_0, C_1 .. around the edge i j, in
// 2D the segment from C_0 to C_1. With e = x_j - x_i and P_k = C_k - C_0 its area is the sum of
//
//     a_k = e . (P_k x P_k+1) / (2 |e|),
//
// and its centroid is C_0 plus the mean of (P_k + P_k+1) / 3 with these weights.
//
// Errors, u = 2^-53; |v| is the sum of the magnitudes of the coordinates of a vector, an upper bound of its length. C_k
// relative to x_i is off by h_k: a circumcentre's own bound, and u of the difference and the sum on the way. P_k is
// then off by h_k + h_0 and by a rounding, u |P_k|, which g_k is to cover, too. So
//
//     2 a_k   is off by   |P_k| g_k+1 + |P_k+1| g_k + g_k g_k+1 + 16 u |P_k| |P_k+1|:
//
// a coordinate of the product of two vectors is two products and a difference, 2 u of its terms, the sum of three
// times e another 4 u of terms that add up to less than |e|_2 |P_k| |P_k+1|, the direction e / |e| 4 u: facet_area_3 u
// at most (proofs/gappa/voronoi_facets_3.g), of the 16. The rest is for the rounding of the bound.
// Edges are below 2, in the unit of circumcentre(), so an underflow is an error of 2^-1070 (1 + |P_k|) (1 + |P_k+1|) /
// |e| at most; `lost` covers it, because edges with a coordinate below 2^-400 are left to integers.
//
// A sum of positive terms is as good as the terms; where the bound is above an eighth of the promise, integers
// compute the facet. In 2D the length |C_1 - C_0| is off by g_1 and facet_length_2 u of itself (voronoi_facets_2.g);
// another 4 u are for the rounding of the bound.

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
    /// A circumcentre relative to vertex i, with its error.
    struct Seen {
        Coordinates<d> offset;
        double error;
    };
    enum class Verdict : char { unknown, same, different };

    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    static double absolute_sum(const Coordinates<d>& x) {
        double sum = std::fabs(x[0]);
        for (std::size_t k = 1; k < d; ++k) sum += std::fabs(x[k]);
        return sum;
    }
    /// (b - a) in the unit, each coordinate with a relative error of u at most.
    [[nodiscard]] Coordinates<d> difference(Index a, Index b) const {
        return Euclidean<d>::difference(input_.points[at(b)], input_.points[at(a)],
                                        [this](double p, double q) { return (p - q) * scale_; });
    }
    [[nodiscard]] Seen seen_from(Index a, Index c) const {
        const Index base = input_.cells.vertices[at(c)][0];
        const Circumcentre<d>& centre = centre_[at(c)];
        if (base == a) return {centre.offset, centre.error};
        Seen out{difference(a, base), 0};
        const double far = absolute_sum(out.offset);
        for (std::size_t k = 0; k < d; ++k) out.offset[k] += centre.offset[k];
        out.error = centre.error + bounds::u * (far + absolute_sum(out.offset));
        return out;
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
    constexpr double u = bounds::u;
    constexpr double good = 0x1p-35;
    constexpr double lost = 0x1p-500;
    const Seen first = seen_from(facet.i, facet.ring[0]);
    facet.exponent = exponent_;
    if constexpr (d == 2) {
        const Seen last = seen_from(facet.i, facet.ring[1]);
        const double x = last.offset[0] - first.offset[0];
        const double y = last.offset[1] - first.offset[1];
        const double length = std::sqrt(x * x + y * y);
        facet.measure = length;
        for (std::size_t k = 0; k < 2; ++k) facet.centroid[k] = 0.5 * (first.offset[k] + last.offset[k]);
        const double error = first.error + last.error + (bounds::facet_length_2 + 4) * u * length + lost;
        return error < good * length;
    } else {
        const Coordinates<d> e = difference(facet.i, facet.j);
        const double length = std::sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2]);
        if (!(length > 0x1p-400)) return false;
        Coordinates<d> p{};
        double size = 0;
        double g = 0;
        double sum = 0;
        double error = 0;
        Coordinates<d> moment{};
        for (std::size_t k = 1; k < facet.ring.size(); ++k) {
            const Seen next = seen_from(facet.i, facet.ring[k]);
            const Coordinates<d> r = {next.offset[0] - first.offset[0], next.offset[1] - first.offset[1],
                                      next.offset[2] - first.offset[2]};
            const double size_r = absolute_sum(r);
            const double g_r = next.error + first.error + u * size_r;
            if (k > 1) {
                const double twice = e[0] * (p[1] * r[2] - p[2] * r[1]) + e[1] * (p[2] * r[0] - p[0] * r[2]) +
                                     e[2] * (p[0] * r[1] - p[1] * r[0]);
                sum += twice;
                for (std::size_t a = 0; a < d; ++a) moment[a] += twice * (p[a] + r[a]);
                error += size * g_r + size_r * g + g * g_r + (bounds::facet_area_3 + 5) * u * size * size_r +
                         lost * (1 + size) * (1 + size_r);
            }
            p = r;
            size = size_r;
            g = g_r;
        }
        const double twice_area = sum / length;
        facet.measure = 0.5 * twice_area;
        for (std::size_t a = 0; a < d; ++a) facet.centroid[a] = first.offset[a] + moment[a] / (3 * sum);
        return error < good * twice_area;
    }
}

extern template class Voronoi_facets<2>;
extern template class Voronoi_facets<3>;

}  // namespace annulus::inline v1
