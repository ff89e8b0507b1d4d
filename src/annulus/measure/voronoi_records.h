// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/saturated.h>
#include <annulus/measure/voronoi_input.h>
#include <annulus/voronoi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Sums over the facets of one Voronoi cell. long double, because of its range: no volume overflows or underflows.
template <int d>
struct Cell_sums {
    using Vector = std::array<long double, static_cast<std::size_t>(d)>;

    long double measures = 0, prisms = 0;
    Vector moment{};

    /// A pyramid over a facet with the vertex as apex; the centroid of the facet relative to it.
    void add(long double measure, long double height, const Vector& to) {
        const long double prism = measure * height;
        measures += measure;
        prisms += prism;
        for (std::size_t k = 0; k < d; ++k) moment[k] += prism * to[k];
    }
    [[nodiscard]] long double volume() const { return prisms / d; }
    /// Relative to the vertex: the centroid of a pyramid is d / (d + 1) of the way to that of its facet.
    [[nodiscard]] long double centroid(std::size_t k) const { return moment[k] / prisms * d / (d + 1); }
};

/// A facet in the caller's unit.
template <int d>
struct Facet_record {
    Index i, j;
    double measure, distance;
    Coordinates<d> centroid, vector;
    std::size_t ring_begin, ring_size;
    bool bounded, empty;
};

/// Makes room for this many facets and elements of rings.
template <int d>
void reserve_facets(Voronoi_diagram<d>& out, std::size_t facets, std::size_t rings) {
    out.pair.reserve(facets);
    out.measure.reserve(facets);
    out.centroid.reserve(facets);
    out.distance.reserve(facets);
    out.vector.reserve(facets);
    out.exactly_empty.reserve(facets);
    out.ring_begin.reserve(facets + 1);
    out.ring.reserve(rings);
}

/// Facets of a Voronoi diagram in the order in which they were visited, and their sums by cell. This order makes the
/// sums: neighbours follow each other in it, so that sums are in the cache.
template <int d>
class Facet_records {
  public:
    /// `exponent`: of the unit of most facets. Refers to the points.
    Facet_records(std::span<const Coordinates<d>> points, int exponent, std::size_t expected)
        : points_(points), exponent_(exponent), unit_(std::ldexp(1.0L, exponent)), sums_(points.size()) {
        records_.reserve(expected);
    }

    /// A Voronoi_facet or Periodic_facet, and the numbers of the vertices around it.
    template <class Facet>
    void add(const Facet& facet, std::span<const Index> ring) {
        constexpr double unbounded = std::numeric_limits<double>::infinity();
        Facet_record<d>& r = records_.emplace_back(Facet_record<d>{facet.i,
                                                                   facet.j,
                                                                   unbounded,
                                                                   facet.distance,
                                                                   {},
                                                                   facet.vector,
                                                                   rings_.size(),
                                                                   ring.size(),
                                                                   facet.bounded,
                                                                   facet.empty});
        rings_.insert(rings_.end(), ring.begin(), ring.end());
        const bool finite = facet.measure < unbounded;
        const long double unit = facet.exponent == exponent_ ? unit_ : std::ldexp(1.0L, facet.exponent);
        const long double measure = d == 2 ? facet.measure * unit : facet.measure * unit * unit;
        if (finite) r.measure = saturated(measure);
        typename Cell_sums<d>::Vector from_i{};
        typename Cell_sums<d>::Vector from_j{};
        for (std::size_t k = 0; k < d; ++k) {
            from_i[k] = facet.centroid[k] * unit;
            from_j[k] = from_i[k] - facet.vector[k];
            r.centroid[k] = points_[at(facet.i)][k] + static_cast<double>(from_i[k]);
        }
        if (facet.empty || !finite) return;
        const long double height = static_cast<long double>(facet.distance) / 2;
        sums_[at(facet.i)].add(measure, height, from_i);
        sums_[at(facet.j)].add(measure, height, from_j);
    }

    [[nodiscard]] std::span<const Facet_record<d>> records() const { return records_; }
    [[nodiscard]] std::span<const Index> ring_of(const Facet_record<d>& r) const {
        return {rings_.data() + r.ring_begin, r.ring_size};
    }
    [[nodiscard]] std::size_t length_of_rings() const { return rings_.size(); }
    /// The numbers of the records, ascending by i, and those of one i by less(number, number): counted by i, then
    /// sorted, a few each.
    template <class Less>
    [[nodiscard]] std::vector<std::size_t> in_order(Less less) const {
        std::vector<std::size_t> begin(points_.size() + 1, 0);
        for (const Facet_record<d>& f : records_) ++begin[at(f.i) + 1];
        std::partial_sum(begin.begin(), begin.end(), begin.begin());
        std::vector<std::size_t> order(records_.size());
        std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
        for (std::size_t k = 0; k < records_.size(); ++k) order[end[at(records_[k].i)]++] = k;
        for (std::size_t v = 0; v < points_.size(); ++v)
            std::sort(order.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                      order.begin() + static_cast<std::ptrdiff_t>(end[v]), less);
        return order;
    }

    /// Appends a facet to a diagram.
    void write(const Facet_record<d>& r, Voronoi_diagram<d>& out) const {
        out.measure.push_back(r.measure);
        out.centroid.push_back(r.centroid);
        out.distance.push_back(r.distance);
        out.vector.push_back(r.vector);
        out.exactly_empty.push_back(r.empty ? 1 : 0);
        if (!r.bounded && r.ring_size > 0) out.ring.push_back(-1);
        const auto ring = ring_of(r);
        out.ring.insert(out.ring.end(), ring.begin(), ring.end());
        out.ring_begin.push_back(static_cast<Index>(out.ring.size()));
    }
    /// Sets volume, surface and centroid of the cell of v, of which all facets have been added.
    void write_cell(std::size_t v, Vertex_location where, Voronoi_diagram<d>& out) const {
        const bool inside = where == Vertex_location::inside;
        const double otherwise = where == Vertex_location::hull ? std::numeric_limits<double>::infinity()
                                                                : std::numeric_limits<double>::quiet_NaN();
        out.volume[v] = inside ? saturated(sums_[v].volume()) : otherwise;
        out.surface[v] = inside ? saturated(sums_[v].measures) : otherwise;
        for (std::size_t k = 0; k < d; ++k)
            out.cell_centroid[v][k] = inside ? static_cast<double>(points_[v][k] + sums_[v].centroid(k))
                                             : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    std::span<const Coordinates<d>> points_;
    int exponent_;
    long double unit_;
    std::vector<Facet_record<d>> records_;
    std::vector<Index> rings_;
    std::vector<Cell_sums<d>> sums_;
};

}  // namespace annulus::inline v1
